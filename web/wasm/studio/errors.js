// Why a file cannot be read, in the reader's language: the rule that is broken and what to do, for whoever reads no English.
import {errors} from 'odontoscope:errors';   // of assets/languages, by tag: {de: {'too-few-points': [rule, what to do], ...}}

/// {language, sentences} for a message of the engine, which ends with its cause in brackets; null: it is English that is wished for first, or there are no words.
export function explained(message, wishes = navigator.languages) {
  const cause = /\[([a-z0-9-]+)\]\s*$/.exec(message)?.[1];
  for (const wish of wishes) {
    const language = wish.toLowerCase().split('-')[0];
    if (language === 'en') return null;
    const sentences = errors[language]?.[cause];
    if (sentences) return {language, sentences};
  }
  return null;
}
