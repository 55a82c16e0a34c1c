/** Names relative to the run's folder, "series/slice1.dcm" too, and what they hold. Text is written as UTF-8. */
export type Files = Record<string, Uint8Array | ArrayBuffer | string>;
/** `stage` is a word or two for a person ("triangulate"), `fraction` how much of it is done, 0 to 1. */
export type ProgressListener = (stage: string, fraction: number) => void;

export interface RunOptions {
  files?: Files;
  onProgress?: ProgressListener;
}

export interface Result {
  /** 0 done, 1 checked and found wanting, 2 wrong options, 3 bad input, 4 a file, 70 a bug of ours. */
  exitCode: number;
  /** Lines of what the program found. */
  said: string[];
  /** Lines of warnings and errors. */
  complained: string[];
  /** What was written; empty unless exitCode is 0 or 1. */
  files: Record<string, Uint8Array>;
  /** Of `web`, made of contours or a volume: its model in the formats of `reconstruct`, without making it again. It holds the engine's memory. */
  save: ((options: SaveOptions) => Promise<Omit<Result, 'save'>>) | null;
}

export interface SaveOptions {
  /** Names to write; the ending says the format. */
  output?: string | readonly string[];
  /** Name of a JSON file to write: certificate, counts, links, times. */
  report?: string;
  /** Mesh anew for simulation: edges of about so many mm, or "quality". */
  elements?: number | 'quality';
  onProgress?: ProgressListener;
}

export interface Done extends Result {
  /** exitCode was 1. */
  wanting: boolean;
}

/** An option of the program: `minArea: 4` is `--min-area 4`, `true` an option without a value, an array of strings one that is repeated,
 *  an array of numbers one value with commas. */
export type OptionValue = string | number | boolean | null | undefined | readonly string[] | readonly number[] | readonly (readonly number[])[];

export interface CommandOptions extends RunOptions {
  /** Name of the file among `files`. */
  input?: string | readonly string[];
  /** Names to write; the ending says the format. */
  output?: string | readonly string[];
  [option: string]: OptionValue | Files | ProgressListener;
}

export interface VolumeOptions extends CommandOptions {
  /** Grey value at the surface. */
  iso?: number | readonly string[];
  /** Of a label map: the label, or NAME=N. */
  label?: number | string | readonly string[];
  /** Contours smaller than this many pixels are noise. */
  minArea?: number;
}

export interface ReconstructOptions extends VolumeOptions {
  method?: 'dt' | 'db';
  /** Name of a JSON file to write: certificate, counts, links, times. */
  report?: string;
  /** Simplify the surfaces to at most so many triangles in all. */
  triangles?: number;
  strict?: boolean;
  partition?: boolean;
  /** DB: points of the grid along its longer side. */
  grid?: number | string;
  cases?: string;
}

export declare class OdontoscopeError extends Error {
  exitCode: number;
  /** The cause in brackets at the message's end, as docs/formats.md lists them: "out-of-memory"; null: none. */
  causeId: string | null;
  said: string[];
  complained: string[];
}

export declare class Engine {
  /** How many threads each run has. */
  readonly threads: number;
  /** One run of the program. Does not throw for what the program refuses: look at exitCode. */
  run(words: readonly (string | number)[], options?: RunOptions): Promise<Result>;
  command(name: string, options?: CommandOptions): Promise<Done>;
  sample(kind: string, options?: CommandOptions): Promise<Done>;
  contours(options: VolumeOptions): Promise<Done>;
  reconstruct(options: ReconstructOptions): Promise<Done>;
  check(options: CommandOptions): Promise<Done>;
  canal(options: CommandOptions): Promise<Done>;
  anatomy(options: VolumeOptions): Promise<Done>;
  compare(options: VolumeOptions): Promise<Done>;
  web(options: VolumeOptions): Promise<Done>;
}

/** Compiles the engine once; without arguments from the files beside the package's own. */
export declare function load(from?: {
  wasm?: WebAssembly.Module | BufferSource | Promise<BufferSource>;
  page?: Uint8Array | string;
  /** Of compressed DICOM. */
  decoder?: WebAssembly.Module | BufferSource | Promise<BufferSource>;
  /** Threads of each run, 16 at most. Default: as many as there are processors, in Node.js and in workers of pages that are isolated (COOP and COEP); else, and with
   *  `wasm`, one. */
  threads?: number;
  /** Where the files of the package's folder "threads" lie, if not there. */
  threaded?: string | URL;
}): Promise<Engine>;

/** The words of a command line that options stand for. */
export declare function words(command: string, options?: CommandOptions): string[];

export declare function run(words: readonly (string | number)[], options?: RunOptions): Promise<Result>;
export declare function sample(kind: string, options?: CommandOptions): Promise<Done>;
export declare function contours(options: VolumeOptions): Promise<Done>;
export declare function reconstruct(options: ReconstructOptions): Promise<Done>;
export declare function check(options: CommandOptions): Promise<Done>;
export declare function canal(options: CommandOptions): Promise<Done>;
export declare function anatomy(options: VolumeOptions): Promise<Done>;
export declare function compare(options: VolumeOptions): Promise<Done>;
export declare function web(options: VolumeOptions): Promise<Done>;
