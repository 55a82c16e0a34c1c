// How long a line is on a film, beside how long it is: a film shows what lies square to the rays, and what leans
// towards the tube or away from it shorter.
import {Vector3} from 'three';

/// Of points in millimetres, as the camera's rays throw them onto a film through `centre`, square to where the camera
/// looks; so that what lies there has its own size.
export function lengthOnFilm(points, camera, centre) {
  const eye = camera.position,
    ahead = camera.getWorldDirection(new Vector3());
  const distance = centre.clone().sub(eye).dot(ahead),
    before = new Vector3(),
    here = new Vector3();
  let sum = 0;
  points.forEach((point, index) => {
    here.set(...point).sub(eye);
    const depth = here.dot(ahead);
    if (camera.isOrthographicCamera) here.addScaledVector(ahead, -depth);
    else here.multiplyScalar(distance / depth);
    if (index > 0) sum += here.distanceTo(before);
    before.copy(here);
  });
  return sum;
}

export function trueLength(points) {
  const step = (point, index) => Math.hypot(...point.map((x, k) => x - points[index][k]));
  return points.slice(1).reduce((sum, point, index) => sum + step(point, index), 0);
}
