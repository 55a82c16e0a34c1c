// What the page's address asks for behind its #: "step=3", "quiz&seed=7", "handout". Words that it does not know are kept.

const known = ['step', 'quiz', 'seed', 'handout'];

const asWords = params => [...params].map(([key, value]) => value === '' ? encodeURIComponent(key) : `${encodeURIComponent(key)}=${encodeURIComponent(value)}`).join('&');
const whole = text => /^\d{1,9}$/.test(text ?? '') ? Number(text) : null;

/// {step, quiz, seed, handout, parent}: null where it does not speak of it. `words`: all of it, for who knows others (showing.js). `quiz`: 'lesson', 'model', or '' for whichever there is.
export function asked(hash = location.hash) {
  const params = new URLSearchParams(hash.replace(/^#/, ''));
  return {step: whole(params.get('step')), quiz: params.get('quiz'), seed: whole(params.get('seed')), handout: params.has('handout'), parent: params.get('parent'), words: params};
}

/// Puts it into the address in place of what it says of `keys`, without a step in the browser's history.
export function tell(change, keys = known) {
  const params = new URLSearchParams(location.hash.replace(/^#/, ''));
  for (const key of [...params.keys()]) if (keys.includes(key) || document.getElementById(key)) params.delete(key);
  for (const [key, value] of Object.entries(change)) if (value !== null && value !== undefined) params.append(key, value);
  const words = asWords(params);
  if (`#${words}` === location.hash) return;
  try {
    history.replaceState(null, '', `#${words}`);
  } catch {
    // A frame that may not: the page works without.
  }
}
