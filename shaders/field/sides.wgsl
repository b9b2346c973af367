#import shapes

// A shape, or one of its smooth sides alone and beyond its edges. Twin of Facets in src/shape/shape.ts.

const ALL_SIDES = 0xffffffffu;

// to be set before shape_field is called
var<private> wanted_side: u32;
// set by it: the side that the nearest place of the surface is on
var<private> found_side: u32;

fn shape_field(shape: Shape, p: vec3f) -> vec4f {
  if (wanted_side != ALL_SIDES) {
    return shape_on_side(shape, p, wanted_side);
  }
  found_side = shape_side(shape, p);
  return whole_shape(shape, p);
}
