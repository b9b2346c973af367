#import polygonize/crossing

// A vertex on each crossed edge, on the surface of the field as it is in the brick that owns the edge. Then, when emit.wgsl has put
// vertices in the middle of loops, those too: along the mean of their normals.

@group(0) @binding(1) var<storage, read> values: array<f32>;
@group(0) @binding(2) var<storage, read> vertex_edges: array<u32>;
@group(0) @binding(3) var<storage, read_write> positions: array<vec4f>;
@group(0) @binding(4) var<storage, read_write> normals: array<vec4f>;
@group(0) @binding(5) var<storage, read_write> colours: array<vec4f>;
// first vertex, and how many
@group(0) @binding(10) var<uniform> span: vec4u;

// steps to both sides in which the surface is looked for from the middle of a loop at most
const AROUND = 0.25;

@compute @workgroup_size(64)
fn vertices(
  @builtin(workgroup_id) group: vec3u,
  @builtin(num_workgroups) groups: vec3u,
  @builtin(local_invocation_index) thread: u32,
) {
  let item = item_of(group, groups, thread);
  if (item >= span.y) {
    return;
  }
  let vertex = span.x + item;
  let edge = vertex_edges[vertex] % 384u;
  let brick = vertex_edges[vertex] / 384u;
  let header = lists[brick];
  var search: Search;
  if (edge == 375u) {
    search = across_middle(positions[vertex].xyz, normals[vertex].xyz);
  } else {
    let a = 4u * brick_place(header) + node_place(edge / 3u);
    let at = 128u * brick + edge / 3u;
    let ends = vec2f(values[at], values[at + vec3u(1u, 5u, 25u)[edge % 3u]]);
    search = along_edge(a, a + unit_along(edge % 3u), ends);
  }
  let point = surface_crossing(header.y, search);
  positions[vertex] = vec4f(point.position, 1.0);
  normals[vertex] = vec4f(point.normal, 0.0);
  colours[vertex] = vec4f(point.colour, 1.0);
}

// within the cell, and not in its faces
fn across_middle(middle: vec3f, normal: vec3f) -> Search {
  let place = fract((middle - lattice.origin) / lattice.step);
  let room = max(min(place, 1.0 - place) - 0.01, vec3f(0.0)) / max(abs(normal), vec3f(1e-6));
  let reach = min(min(room.x, room.y), min(room.z, AROUND)) * lattice.step * normal;
  return Search(middle - reach, 2.0 * reach, vec2f(UNKNOWN, -UNKNOWN), normal);
}

fn along_edge(a: vec3u, b: vec3u, ends: vec2f) -> Search {
  var normal = vec3f(b - a) * select(1.0, -1.0, ends.y > 0.0);
  if (is_cut(ends)) {
    normal = normalize(vec3f(node_side(a) + node_side(b)));
  }
  return Search(node_position(a), lattice.step * vec3f(b - a), ends, normal);
}
