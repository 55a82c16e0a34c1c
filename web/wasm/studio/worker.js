// The engine away from the page's thread: one run at a time. Ending the worker is how a run is cancelled.
import {load} from '../npm/index.mjs';

let engine = null, save = null;

addEventListener('message', async ({data}) => {
  try {
    if (data.wasm) {
      engine = await load(data);
      postMessage({ready: true, threads: engine.threads});
      return;
    }
    const onProgress = (stage, fraction) => postMessage({stage, fraction});
    const page = data.words?.[0] === 'web';
    if (page) save = null;   // the memory of the model before
    const {save: saved, ...result} = await (data.save ? save({...data.save, onProgress}) : engine.run(data.words, {files: data.files, onProgress}));
    if (page) save = saved;
    result.canSave = save !== null;
    postMessage({result}, Object.values(result.files).map(bytes => bytes.buffer));
  } catch (error) {
    postMessage({result: {exitCode: 70, said: [], complained: [error.message], files: {}}});
  }
});
