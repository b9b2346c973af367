#import skeleton

// The field of all skels at each point of a list: (value, gradient).

@group(0) @binding(0) var<storage, read> places: array<vec4f>;
@group(0) @binding(1) var<storage, read_write> results: array<vec4f>;

@compute @workgroup_size(64)
fn sum_at_points(@builtin(global_invocation_id) id: vec3u) {
  let i = id.x;
  if (i >= arrayLength(&places)) {
    return;
  }
  let p = places[i].xyz;
  var sum = vec4f(0.0);
  for (var k = 0u; k < arrayLength(&skels); k++) {
    sum += skel_field(skels[k], p);
  }
  results[i] = sum;
}
