#import polygonize/near
#import polygonize/owner
#import bricks

// The values at the nodes that each brick owns. A group is a brick.

@group(0) @binding(1) var<storage, read_write> values: array<f32>;

@compute @workgroup_size(128)
fn nodes(
  @builtin(workgroup_id) group: vec3u,
  @builtin(num_workgroups) groups: vec3u,
  @builtin(local_invocation_index) node: u32,
) {
  let brick = own_brick(group, groups);
  if (brick >= lattice.bricks.w || node >= 125u) {
    return;
  }
  let header = lists[brick];
  let n = 4u * brick_place(header) + node_place(node);
  let owner = owner_of_node(n);
  if (owner.number != i32(brick)) {
    return;
  }
  let value = node_value(header, node_position(n));
  // what is proven there holds here too: the sign is right, and the value next to nothing
  let is_wrong = owner.sign != 0 && (value > 0.0) != (owner.sign > 0);
  values[128u * brick + node] = select(value, 1e-30 * f32(owner.sign), is_wrong);
}

// By the brick's lists, and where these leave it in doubt by everything.
fn node_value(header: vec4u, p: vec3f) -> f32 {
  var value = 0.0;
  for (var round = 0u; round < 2u; round++) {
    value = near_field(select(WHOLE, header.y, round == 0u), p, false).x;
    if (abs(value) > bitcast<f32>(header.z)) {
      break;
    }
  }
  return value;
}
