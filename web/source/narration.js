// A step said aloud: by the browser's own speech, in the lesson's language, sentence by sentence, with each sentence as a caption in the picture. Only voices of
// this machine speak: others would send the words over the network. Where there is none, the text is there to be read.
import {element} from './dom.js';
import {language, t} from './language.js';

const speech = globalThis.speechSynthesis ?? null;
const paragraphs = text => String(text ?? '').split(/\n+/).filter(Boolean);
/// Short enough for a caption.
const sentences = text => paragraphs(text).flatMap(line => line.match(/.+?(?:[.!?\u2026](?=\s|$)|$)/g)).map(words => words.trim()).filter(Boolean);

export class Narration {
  /// `tongue`: the language's tag; '' for the page's own.
  constructor(tongue) {
    this.tongue = tongue || language.language;
    this.on = false;         // and stays so from step to step
    this.unfolded = null;    // as somebody wanted it
    this.caption = element('p', {id: 'caption', 'aria-hidden': 'true', hidden: true});   // for the eye: the text is in the card
    document.getElementById('caption')?.remove();
    document.getElementById('stage').append(this.caption);
    this.heard = () => this.offer();
    speech?.addEventListener?.('voiceschanged', this.heard);
  }

  get voice() {
    const short = tag => tag.toLowerCase().split(/[-_]/)[0];
    return speech?.getVoices().find(({localService, lang}) => localService && short(lang) === short(this.tongue)) ?? null;
  }

  /// What the card shows of it: the text, folded, and the button.
  parts(note) {
    this.note = note;
    this.button = element('button', {type: 'button', onclick: () => this.turn(!this.on)});
    const text = paragraphs(note.narration);
    this.text = text.length > 0 ? element('details', {class: 'narration'},
      element('summary', {onclick: () => { this.unfolded = !this.text.open; }}, t('Narration')), ...text.map(line => element('p', {}, line))) : null;
    this.offer();
    return [this.text, element('div', {class: 'row'}, this.button)].filter(Boolean);
  }

  /// Voices may be known later than the page.
  offer() {
    if (!this.button) return;
    if (this.text) this.text.open = this.unfolded ?? !this.voice;
    this.button.hidden = !this.voice || sentences(this.words()).length === 0;
    this.button.textContent = this.on ? t('Stop reading') : t('Read aloud');
    this.button.setAttribute('aria-pressed', String(this.on));
  }

  words() { return this.note?.narration || this.note?.text || ''; }

  turn(on) {
    this.on = on;
    this.offer();
    if (on) this.say();
    else this.silence();
  }

  /// Another step is shown: what was said of the one before ends.
  begin() {
    this.silence();
    if (this.on) this.say();
  }

  say() {
    const {voice} = this, all = sentences(this.words()), turn = this.turnOf = {};
    speech?.cancel();
    if (!voice) return;
    all.forEach((words, index) => {
      const said = new SpeechSynthesisUtterance(words);
      Object.assign(said, {voice, lang: voice.lang});
      said.addEventListener('start', () => { if (this.turnOf === turn) this.show(words); });
      for (const end of ['end', 'error']) said.addEventListener(end, () => { if (this.turnOf === turn && index === all.length - 1) this.show(''); });
      speech.speak(said);
    });
  }

  silence() {
    this.turnOf = null;
    speech?.cancel();
    this.show('');
  }

  show(words) {
    const bar = document.getElementById('bar');
    this.caption.style.bottom = bar.hidden ? '' : `${bar.offsetHeight + 24}px`;   // above what else is said down there
    this.caption.textContent = words;
    this.caption.hidden = words === '';
  }

  close() {
    this.on = false;
    this.silence();
    speech?.removeEventListener?.('voiceschanged', this.heard);
    this.caption.remove();
  }
}
