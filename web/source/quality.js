// How much a picture may cost while things move, learnt from the time that frames take.

export const ways = [
  {layers: false, shade: false},   // of each structure only what is nearest
  {layers: true, shade: false},
  {layers: true, shade: true},
];
const slow = 0.045, quick = 0.022;         // seconds a frame; a browser that saves power draws 30 a second, which is not slow
const slowFrames = 5, quickFrames = 120;   // in a row, before the way changes
const mostFailures = 2;                    // after which a way is not tried again
const restBeforeRefining = 0.3;            // seconds, where a frame takes long: the next movement is not to wait for it

export class Quality {
  /// `saving`: begin without what costs most; `software`: with the least, since no graphics card draws.
  constructor({saving = false, software = false} = {}) {
    this.level = software ? 0 : saving ? 1 : ways.length - 1;
    this.failures = ways.map(() => 0);
    this.slow = this.quick = 0;
  }

  get moving() { return ways[this.level]; }
  get still() { return ways.at(-1); }
  get reduced() { return this.level < ways.length - 1; }

  /// The time from one frame to the next while things move. True if the way changed.
  note(seconds) {
    this.slow = seconds > slow ? this.slow + 1 : 0;
    this.quick = seconds < quick ? this.quick + 1 : 0;
    if (this.slow >= slowFrames && this.level > 0) {
      this.failures[this.level] += 1;
      return this.to(this.level - 1);
    }
    if (this.quick >= quickFrames && this.reduced && this.failures[this.level + 1] < mostFailures) return this.to(this.level + 1);
    return false;
  }

  to(level) {
    this.level = level;
    this.slow = this.quick = 0;
    return true;
  }

  /// May a still picture be made finer, so long after the last movement?
  mayRefine(rested) { return !this.reduced || rested > restBeforeRefining; }
}

const scales = [1, 0.7, 0.5, 0.35, 0.25];   // of the picture's sides, while rays are cast and things move
const muchTooSlow = 0.09;

/// How many pixels rays are cast through while things move, learnt from the time that frames take.
export class Pace {
  constructor({software = false} = {}) {
    this.level = software ? 2 : 0;
    this.quick = 0;
  }
  get scale() { return scales[this.level]; }
  note(seconds) {
    this.quick = seconds < quick ? this.quick + 1 : 0;
    if (seconds > slow) this.level = Math.min(this.level + (seconds > muchTooSlow ? 2 : 1), scales.length - 1);
    if (this.quick < quickFrames || this.level === 0) return;
    this.level -= 1;
    this.quick = 0;
  }
}
