#import field/tree

// The colour at each point of a list: (value, red, green, blue).

@group(0) @binding(0) var<storage, read> places: array<vec4f>;
@group(0) @binding(1) var<storage, read_write> results: array<vec4f>;

@compute @workgroup_size(64)
fn colours_at_points(@builtin(global_invocation_id) id: vec3u) {
  let i = id.x;
  if (i >= arrayLength(&places)) {
    return;
  }
  results[i] = tree_colour(places[i].xyz);
}
