// Box with rounded edges: the smaller box grown by the radius. Twin of src/shape/roundedBox.ts.
#import shape/box

fn rounded_box_field(p: vec3f, half_size: vec3f, radius: f32) -> vec4f {
  return box_field(p, half_size - radius) + vec4f(radius, 0.0, 0.0, 0.0);
}
