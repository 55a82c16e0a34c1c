// The edge of a film that hangs at the tooth's middle, square to where the eye looks, so that what lies there has its own size.
uniform vec2 film;          // its width and height; 0: no edge
uniform vec3 film_centre;   // in eye space
const float beside_film = 0.16;

/// Does a ray, in eye space, miss the film?
bool misses_film(vec3 begin, vec3 way) {
  vec2 off = abs((begin + (film_centre.z - begin.z) / way.z * way - film_centre).xy);
  return film.x > 0.0 && any(greaterThan(off, 0.5 * film));
}
