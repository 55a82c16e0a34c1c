// <odontoscope-tooth src="molar.html">: a page of `odontoscope web` as an element of another page. No dependencies; docs/web.md has the list.
//
//   src       the page; relative to the document
//   poster    a picture to show until somebody asks for the model; it is then loaded by a click or Enter (loading="eager": at once)
//   view, section, hide, faces, method, bare     what it shows, as in the page's own address; may be changed at any time
//   step      of its lesson, from 1
//   label     what the model is called to those who do not see it
// Events, which bubble: ready, state, step, answer, done; `detail` is what the page told. Property `state`: what it shows.
const shown = ['view', 'section', 'hide', 'faces', 'method', 'bare'];
const events = ['ready', 'state', 'step', 'answer', 'done'];

const style = `
:host{display:block;position:relative;min-height:12rem;aspect-ratio:4/3;contain:content}
iframe,button,img{position:absolute;inset:0;width:100%;height:100%;border:0;padding:0;margin:0;display:block}
button{background:#dfe6ec;cursor:pointer}
button:focus-visible{outline:3px solid #0e7c7b;outline-offset:-3px}
img{object-fit:cover}
span{position:absolute;left:50%;bottom:1rem;transform:translateX(-50%);padding:.5rem 1rem;border-radius:2rem;background:#12202bcc;color:#fff;font:600 1rem system-ui,sans-serif;white-space:nowrap}`;

export class OdontoscopeTooth extends HTMLElement {
  static observedAttributes = ['src', 'poster', 'loading', 'label', 'step', ...shown];

  constructor() {
    super();
    this.attachShadow({mode: 'open'});
    this.state = null;
    this.frame = null;
    this.hear = event => this.heard(event);
  }

  connectedCallback() {
    addEventListener('message', this.hear);
    this.draw();
  }
  disconnectedCallback() {
    removeEventListener('message', this.hear);
    this.frame = null;
  }

  attributeChangedCallback(name, before, now) {
    if (!this.isConnected || before === now) return;
    if (name === 'src') this.state = null;
    if (['src', 'poster', 'loading'].includes(name)) return this.draw();
    if (name === 'label') this.shadowRoot.querySelector('iframe, button')?.setAttribute('aria-label', this.name);
    if (name === 'step') this.go(Number(now));
    if (shown.includes(name)) this.ask({ask: 'show', state: {[name]: now ?? {section: 'off', hide: '', faces: 'cull', bare: 'off'}[name] ?? ''}});
  }

  get name() { return this.getAttribute('label') ?? 'A tooth to turn and cut open'; }

  /// The page with all that it shall show in its address.
  get address() {
    const url = new URL(this.getAttribute('src'), document.baseURI), words = new URLSearchParams(url.hash.slice(1));
    for (const name of [...shown, 'step']) if (this.hasAttribute(name)) words.set(name, this.getAttribute(name));
    if (/^https?:$/.test(location.protocol)) words.set('parent', location.origin);
    url.hash = words;
    return url;
  }

  draw() {
    this.frame = null;
    const sheet = document.createElement('style');
    sheet.textContent = style;
    this.shadowRoot.replaceChildren(sheet);
    if (!this.hasAttribute('src')) return;
    if (this.hasAttribute('poster') && this.getAttribute('loading') !== 'eager') this.drawPoster();
    else this.load();
  }

  drawPoster() {
    const button = document.createElement('button'), picture = document.createElement('img'), words = document.createElement('span');
    button.type = 'button';
    button.setAttribute('aria-label', `${this.name}: show it`);
    picture.src = new URL(this.getAttribute('poster'), document.baseURI);
    picture.alt = '';
    words.textContent = 'Turn it';
    button.append(picture, words);
    button.addEventListener('click', () => { button.remove(); this.load(); this.frame.focus(); });
    this.shadowRoot.append(button);
  }

  /// Loads the model, if that has not begun.
  load() {
    if (this.frame) return;
    this.frame = document.createElement('iframe');
    this.frame.setAttribute('aria-label', this.name);
    this.frame.allow = 'fullscreen; xr-spatial-tracking';
    this.frame.src = this.address;
    this.shadowRoot.append(this.frame);
  }

  /// Leads to a step of its lesson, from 1.
  go(step) { this.ask({ask: 'go', step}); }

  ask(message) {
    if (!this.frame) return;
    const {origin} = this.address;
    this.frame.contentWindow?.postMessage({source: 'odontoscope', ...message}, origin === 'null' ? '*' : origin);
  }

  heard({source, origin, data}) {
    if (!this.frame || source !== this.frame.contentWindow || origin !== this.address.origin || data?.source !== 'odontoscope') return;
    if (!events.includes(data.event)) return;
    if (data.event === 'state') this.state = data.state;
    this.dispatchEvent(new CustomEvent(data.event, {detail: data, bubbles: true, composed: true}));
  }
}

if (!customElements.get('odontoscope-tooth')) customElements.define('odontoscope-tooth', OdontoscopeTooth);
