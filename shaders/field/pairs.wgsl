#import skeleton

// The field of the first skel at the first point, of the second at the second, …: (value, gradient).

@group(0) @binding(0) var<storage, read> places: array<vec4f>;
@group(0) @binding(1) var<storage, read_write> results: array<vec4f>;

@compute @workgroup_size(64)
fn each_at_its_point(@builtin(global_invocation_id) id: vec3u) {
  let i = id.x;
  if (i >= arrayLength(&places)) {
    return;
  }
  results[i] = skel_field(skels[i], places[i].xyz);
}
