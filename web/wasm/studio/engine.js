// The worker from the page's side.

async function unpacked(id) {
  const held = document.getElementById(id), bytes = Uint8Array.from(atob(held.textContent.trim()), letter => letter.charCodeAt(0));
  held.remove();
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'))).arrayBuffer();
}

/// Where a page that is isolated finds the engine for several threads; null: it is not, or has none beside it.
function threadsFolder() {
  const {threads} = document.documentElement.dataset;
  return threads && crossOriginIsolated ? new URL(threads, location.href).href : null;
}

export class Cancelled extends Error {}

export class Engine {
  #worker = null;
  #parts = null;
  #waiting = null;
  #saved = false;
  threads = 1;   // of each run, once there was one

  async #ready() {
    if (this.#worker) return;
    this.#parts ??= Promise.all([unpacked('wasm'), unpacked('shell'), unpacked('decoder'), URL.createObjectURL(new Blob([document.getElementById('worker').textContent], {type: 'text/javascript'}))]);
    const [wasm, page, decoder, url] = await this.#parts;
    const worker = new Worker(url);
    await new Promise((resolve, reject) => {
      worker.onmessage = ({data}) => data.ready ? resolve(this.threads = data.threads) : reject(new Error(data.result.complained.join(' ')));
      worker.onerror = event => reject(new Error(event.message || 'the worker does not start'));
      worker.postMessage({wasm, page: new Uint8Array(page), decoder, threaded: threadsFolder() ?? undefined});
    });
    this.#worker = worker;
  }

  /// One run; onProgress(stage, fraction). Throws Cancelled.
  run(words, files, onProgress) { return this.#asked({words, files}, onProgress); }

  /// The last page's model as files, without making it again: options of `save`. Where the worker was ended meanwhile there is none.
  save(options, onProgress) { return this.#asked({save: options}, onProgress); }

  async #asked(message, onProgress) {
    await this.#ready();
    return new Promise((resolve, reject) => {
      const over = settle => value => {
        this.#waiting = null;
        settle(value);
      };
      this.#waiting = over(reject);
      this.#worker.onmessage = ({data}) => {
        if (!data.result) return onProgress(data.stage, data.fraction);
        this.#saved = Boolean(data.result.canSave);
        over(resolve)(data.result);
      };
      this.#worker.onerror = event => {
        this.#end();
        over(resolve)({exitCode: 70, said: [], complained: [`the engine ended: ${event.message}`], files: {}});
      };
      this.#worker.postMessage(message);
    });
  }

  /// Does the worker still hold the last page's model?
  get holds() { return this.#saved; }

  #end() {
    this.#worker?.terminate();
    this.#worker = null;
    this.#saved = false;
  }

  cancel() {
    const waiting = this.#waiting;
    if (!waiting) return;
    this.#end();
    waiting(new Cancelled());
  }
}
