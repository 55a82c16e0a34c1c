// Compressed DICOM frames, decoded in a module of their own: an instance for each run, with memory that the engine's is none of. What it dies of is a frame that
// cannot be decoded.

const notThere = 8;   // WASI's "bad file descriptor": it has no files, no clock and no environment

/// Whatever the module asks its surroundings for.
function surroundings(module) {
  const imports = {};
  for (const {module: from, name, kind} of WebAssembly.Module.imports(module)) {
    if (kind !== 'function') throw new WebAssembly.LinkError(`the decoder wants ${name}`);
    (imports[from] ??= {})[name] = name === 'emscripten_notify_memory_growth' ? () => {}
      : name === 'proc_exit' ? () => { throw new WebAssembly.RuntimeError('the decoder ended'); }
      : () => notThere;
  }
  return imports;
}

class Decoder {
  #made;
  #dead = false;
  constructor({exports}) {
    this.#made = exports;
    exports._initialize?.();
  }

  /// Is there a decoder for the transfer syntax?
  knows(syntax) { return this.#tried(() => this.#made.odontoscope_knows(this.#text(syntax)) !== 0) ?? false; }

  /// The frame's numbers, or null. `numbers`: rows, columns, bits allocated, bits stored, highest bit, signed.
  decode(syntax, photometric, numbers, bytes, wanted) {
    return this.#tried(() => {
      const {odontoscope_head: head, odontoscope_decode: decode, free, memory} = this.#made;
      const words = [this.#text(syntax), this.#text(photometric)], packed = this.#put(bytes);
      head(...words, ...numbers);
      const at = decode(packed, bytes.length) >>> 0, decoded = at === 0 ? null : new Uint8Array(memory.buffer, at, wanted);
      for (const one of [...words, packed]) free(one);
      return decoded;
    });
  }

  #tried(work) {
    if (this.#dead) return null;
    try {
      return work();
    } catch {   // trapped, out of memory, an exception of C++
      this.#dead = true;
      return null;
    }
  }

  #put(bytes) {
    const at = this.#made.odontoscope_memory(Math.max(1, bytes.length)) >>> 0;
    if (at === 0) throw new RangeError('no memory');
    new Uint8Array(this.#made.memory.buffer, at, bytes.length).set(bytes);
    return at;
  }

  #text(words) { return this.#put(new TextEncoder().encode(`${words}\0`)); }
}

export const decoderOf = async module => new Decoder(await WebAssembly.instantiate(module, surroundings(module)));

const magic = [0x44, 0x49, 0x43, 0x4d], magicAt = 128;   // DICM

/// Could these bytes be a DICOM file with compressed pixels? It names its transfer syntax in group 2, behind the preamble or at its beginning.
export const mayBeCompressed = bytes => magic.every((byte, n) => bytes[magicAt + n] === byte) || (bytes[0] === 2 && bytes[1] === 0);
