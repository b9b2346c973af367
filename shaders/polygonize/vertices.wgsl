#import polygonize/crossing

// A vertex on each crossed edge, on the surface of the field as it is in the brick that owns the edge. Then, when emit.wgsl has put
// vertices in the middle of loops, those too: from there towards corners of the cell, of which some are on the other side.

@group(0) @binding(1) var<storage, read> values: array<f32>;
@group(0) @binding(2) var<storage, read> vertex_edges: array<u32>;
@group(0) @binding(3) var<storage, read_write> positions: array<vec4f>;
// and the branch
@group(0) @binding(4) var<storage, read_write> normals: array<vec4f>;
@group(0) @binding(5) var<storage, read_write> colours: array<vec4f>;
// first vertex, and how many
@group(0) @binding(10) var<uniform> span: vec4u;

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
  let edge = vertex_edges[vertex] % 512u;
  let brick = vertex_edges[vertex] / 512u;
  let header = lists[brick];
  let corner = 4u * brick_place(header);
  var search: Search;
  if (edge >= 384u) {
    search = through_middle(brick, corner, cell_place(edge - 384u), positions[vertex].xyz);
    search.normal = normals[vertex].xyz;
  } else {
    let at = 128u * brick + edge / 3u;
    let a = corner + node_place(edge / 3u);
    let ends = vec2f(values[at], values[at + vec3u(1u, 5u, 25u)[edge % 3u]]);
    search = along_edge(a, a + unit_along(edge % 3u), ends);
  }
  let point = surface_crossing(header.y, search);
  positions[vertex] = vec4f(point.position, 1.0);
  normals[vertex] = vec4f(point.normal, point.branch);
  colours[vertex] = vec4f(point.colour, 1.0);
}

// From the corner that is deepest inside to the middle and on to the corner that is farthest outside.
fn through_middle(brick: u32, corner: vec3u, place: vec3u, middle: vec3f) -> Search {
  var search = Search(middle, middle, middle, vec2f(0.0), vec3f(0.0), 0.5);
  for (var i = 0u; i < 8u; i++) {
    let p = place + ((vec3u(i) >> vec3u(0u, 1u, 2u)) & vec3u(1u));
    let value = values[128u * brick + dot(p, vec3u(1u, 5u, 25u))];
    if (is_inside(corner + p, value) && value > search.ends.x) {
      search.ends.x = value;
      search.start = node_position(corner + p);
    } else if (value < search.ends.y) {
      search.ends.y = value;
      search.end = node_position(corner + p);
    }
  }
  return search;
}

fn along_edge(a: vec3u, b: vec3u, ends: vec2f) -> Search {
  let normal = vec3f(b - a) * select(1.0, -1.0, ends.y > 0.0);
  let start = node_position(a);
  let middle = start + 0.5 * lattice.step * vec3f(b - a);
  var search = Search(start, middle, node_position(b), ends, normal, kept(ends.x / (ends.x - ends.y)));
  if (is_cut(ends)) {
    search.normal = normalize(vec3f(node_side(a) + node_side(b)));
    search.first = 0.5;
  }
  return search;
}
