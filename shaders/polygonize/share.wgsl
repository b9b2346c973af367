#import polygonize/owner
#import bricks

// The values at nodes that a brick holds and does not own, from their owners.

@group(0) @binding(1) var<storage, read_write> values: array<f32>;
@group(0) @binding(2) var<storage, read> lists: array<vec4u>;

@compute @workgroup_size(128)
fn share(
  @builtin(workgroup_id) group: vec3u,
  @builtin(num_workgroups) groups: vec3u,
  @builtin(local_invocation_index) node: u32,
) {
  let brick = own_brick(group, groups);
  if (brick >= lattice.bricks.w || node >= 125u) {
    return;
  }
  let n = 4u * brick_place(lists[brick]) + node_place(node);
  let owner = owner_of_node(n);
  if (owner.number != i32(brick)) {
    let there = dot(n - 4u * owner.place, vec3u(1u, 5u, 25u));
    values[128u * brick + node] = values[128u * u32(owner.number) + there];
  }
}
