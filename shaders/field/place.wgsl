#import record/place

// A leaf that a matrix has moved. Twin of Moved in src/field/leaf.ts.

// The origin is subtracted first: far away little of inverse · p would be left.
fn to_local(place: Place, p: vec3f) -> vec3f {
  return place.inverse * (p - place.origin) + place.low;
}

// value and gradient in mm of the world
fn to_world(place: Place, local: vec4f) -> vec4f {
  return place.scale * vec4f(local.x, local.yzw * place.inverse);
}
