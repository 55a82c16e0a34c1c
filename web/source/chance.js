// Chance that a seed repeats: the same numbers in every browser (Mulberry32, T. Ettinger, public domain).

export function chance(seed) {
  let state = seed >>> 0;
  const next = () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let t = Math.imul(state ^ (state >>> 15), state | 1);
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
  return {
    next,
    below: count => Math.floor(next() * count),
    one: list => list[Math.floor(next() * list.length)],
    shuffled(list) {
      const all = [...list];
      for (let i = all.length - 1; i > 0; --i) {
        const j = Math.floor(next() * (i + 1));
        [all[i], all[j]] = [all[j], all[i]];
      }
      return all;
    },
  };
}
