// In two sentences what a structure is; as the desktop tells it (engine/ui/names.cpp). Terms are those of Nelson and Ash, Wheeler's Dental Anatomy.
import {t} from './language.js';

const known = [
  ['cavity', t('The space that dentine walls in: the pulp chamber in the crown and the canals down the roots. In a living tooth the pulp fills it.')],
  ['enamel', t('The hard cap of the crown, almost wholly mineral, and translucent like frosted glass. It is thickest over the cusps and thins out to an edge at the neck of the tooth.')],
  ['dentin', t('The body of the tooth, under the enamel in the crown and under the cementum in the root. Fine tubules cross it from the pulp outwards, and it walls chamber and canals in.')],
  ['pulp', t('The soft tissue inside, with nerves and vessels: a chamber in the crown, with a horn below each cusp, and canals down the roots to the opening at the tip.')],
  ['cement', t('A thin layer like bone that covers the root. Fibres anchored in it hold the tooth in its socket.')],
  ['bone', t('The jaw\'s bone, with a socket for each root. Fibres run from its wall to the root\'s cementum.')],
  ['tooth', t('All hard tissue of the tooth as one solid. Inside lie the pulp chamber, in the crown, and a canal or more in each root.')],
];

/// Of a look's key; null: nothing is known of it.
export const toldOf = key => known.find(([name]) => key.toLowerCase().includes(name))?.[1] ?? null;
