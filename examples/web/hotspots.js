// Named places in a GLB of `odontoscope reconstruct --hotspots`: nodes whose extras say {hotspot: true}, under a root that turns z up into y up.
export async function hotspotsIn(url) {
  const bytes = await (await fetch(url)).arrayBuffer(), length = new DataView(bytes).getUint32(12, true);
  const {nodes} = JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, 20, length)));
  return nodes.filter(node => node.extras?.hotspot).map(({name, translation: [x, y, z]}) => ({name, position: [x, z, -y]}));   // metres, y up
}
