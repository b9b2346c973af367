#import polygonize/crossing
#import polygonize/state

// A vertex on each crossed edge, on the surface of the field as it is in the brick that owns the edge.

@group(0) @binding(1) var<storage, read> values: array<f32>;
@group(0) @binding(2) var<storage, read> vertex_edges: array<u32>;
@group(0) @binding(3) var<storage, read_write> positions: array<vec4f>;
@group(0) @binding(4) var<storage, read_write> normals: array<vec4f>;
@group(0) @binding(5) var<storage, read_write> colours: array<vec4f>;

@compute @workgroup_size(64)
fn vertices(
  @builtin(workgroup_id) group: vec3u,
  @builtin(num_workgroups) groups: vec3u,
  @builtin(local_invocation_index) thread: u32,
) {
  let vertex = item_of(group, groups, thread);
  if (vertex >= state.counts.x) {
    return;
  }
  let edge = vertex_edges[vertex];
  let brick = edge / 384u;
  let node = (edge % 384u) / 3u;
  let axis = edge % 3u;
  let header = lists[brick];
  let a = 4u * brick_place(header) + node_place(node);
  let b = a + unit_along(axis);
  let at = 128u * brick + node;
  let ends = vec2f(values[at], values[at + vec3u(1u, 5u, 25u)[axis]]);
  let point = crossing_between(header.y, a, b, ends);
  positions[vertex] = vec4f(point.position, 1.0);
  normals[vertex] = vec4f(point.normal, 0.0);
  colours[vertex] = vec4f(point.colour, 1.0);
}
