// What was dropped or chosen, as names and bytes.

async function entriesOf(reader) {
  const all = [];
  for (;;) {
    const some = await new Promise((resolve, reject) => reader.readEntries(resolve, reject));
    if (some.length === 0) return all;
    all.push(...some);
  }
}

async function filesIn(entry, path) {
  if (entry.isFile) return [[path + entry.name, await new Promise((resolve, reject) => entry.file(resolve, reject))]];
  const within = await entriesOf(entry.createReader());
  return (await Promise.all(within.map(one => filesIn(one, `${path}${entry.name}/`)))).flat();
}

export async function dropped(transfer) {
  const entries = [...transfer.items].filter(item => item.kind === 'file').map(item => item.webkitGetAsEntry());
  return (await Promise.all(entries.map(entry => filesIn(entry, '')))).flat();
}

export const chosen = list => [...list].map(file => [file.webkitRelativePath || file.name, file]);

/// The program takes a name that begins with a dash for an option, and names here have no way out of their folder.
const plainName = name => name.split('/').map(part => part.replace(/^[-.]+/, '_').replace(/[\0\\]/g, '_') || '_').join('/');

export async function contentsOf(pairs) {
  const files = {};
  for (const [name, file] of pairs) files[plainName(name)] = new Uint8Array(await file.arrayBuffer());
  return files;
}

const heads = /\.(ser|nhdr|mhd)$/i;

/// Which of several is the one to name: the head of a series or volume, the folder of slices, or the first.
export function mainOf(names) {
  const head = names.find(name => heads.test(name));
  if (head || names.length === 1) return head ?? names[0];
  const folders = new Set(names.map(name => name.split('/').slice(0, -1).join('/')));
  if (folders.size === 1 && !folders.has('')) return [...folders][0];
  return names[0];
}
