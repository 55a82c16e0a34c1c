// What a page around this one, such as a learning platform, is told, and may ask. docs/web.md lists it.
//
// Inside the page: a CustomEvent "odontoscope" on window. To the page that embeds it: a message, only to that page's own origin, so that nothing reaches a
// page that came in its place. Where the origin cannot be known (a page from disk), none is sent.
import {asked} from './address.js';

const httpOrigin = text => {
  try {
    const {protocol, origin} = new URL(text);
    return /^https?:$/.test(protocol) ? origin : null;
  } catch {
    return null;
  }
};

/// Of the page that this one is embedded in, or null. The address may name it: #parent=https://learn.example
export function parentOrigin() {
  if (parent === window) return null;
  const named = asked().parent;
  if (named !== null) return httpOrigin(named);
  return httpOrigin(location.ancestorOrigins?.[0] ?? document.referrer);
}

export function report(event, detail) {
  const told = {source: 'odontoscope', version: 1, event, ...detail};
  dispatchEvent(new CustomEvent('odontoscope', {detail: told}));
  const origin = parentOrigin();
  if (origin) parent.postMessage(told, origin);
}

/// {source: 'odontoscope', ask, ...} from the page that embeds this one, and from no other.
export function listenFor(ask, answer) {
  addEventListener('message', event => {
    const {data} = event;
    if (event.source !== parent || parent === window || event.origin !== parentOrigin()) return;
    if (data?.source === 'odontoscope' && data.ask === ask) answer(data);
  });
}

/// {ask: 'go', step: 3}
export function listen(go) {
  listenFor('go', ({step}) => { if (Number.isInteger(step)) go(step); });
}
