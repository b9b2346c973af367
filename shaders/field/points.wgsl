#import field/tree

// The field at each point of a list: (value, gradient).

@group(0) @binding(0) var<storage, read> points: array<vec4f>;
@group(0) @binding(1) var<storage, read_write> values: array<vec4f>;

@compute @workgroup_size(64)
fn field_at_points(@builtin(global_invocation_id) id: vec3u) {
  let i = id.x;
  if (i >= arrayLength(&points)) {
    return;
  }
  values[i] = tree_field(points[i].xyz);
}
