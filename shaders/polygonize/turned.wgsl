#import polygonize/creased
#import polygonize/loops
#import polygonize/owner
#import polygonize/state

// The triangles around points on creases, in place of those that emit.wgsl made of their loops. Rim edges that cross the crease are turned, so that they
// run along it from point to point; the loops on both sides of one each make a triangle of the two. Twin of src/field/creaseFans.ts,
// but that loops look each other up.

@group(0) @binding(1) var<storage, read> creased_loops: array<CreasedLoop>;
// as number.wgsl left them
@group(0) @binding(2) var<storage, read> cells: array<vec2u>;
// of each brick: what all bricks before it have
@group(0) @binding(3) var<storage, read> before: array<vec4u>;
// of each crossed cell: loops around creases before it
@group(0) @binding(4) var<storage, read> ring_counts: array<vec4u>;
// and the branch
@group(0) @binding(5) var<storage, read> normals: array<vec4f>;
@group(0) @binding(6) var<storage, read> lists: array<vec4u>;
@group(0) @binding(7) var<storage, read_write> indices: array<u32>;

const NO_LOOP = 0xffffffffu;

@compute @workgroup_size(64)
fn turned(
  @builtin(workgroup_id) group: vec3u,
  @builtin(num_workgroups) groups: vec3u,
  @builtin(local_invocation_index) thread: u32,
) {
  let i = item_of(group, groups, thread);
  if (i >= state.creased_loops) {
    return;
  }
  let creased = creased_loops[i];
  let length = ring_length(creased);
  let row = loop_table[creased.row & 65535u];
  let own = length - select(2u, 0u, is_twisted(row, loop_number(creased)));
  let more = state.counts.z + 2u * i;
  for (var k = own; k < own + 2u; k++) {
    add_triangle(more + k - own, vec3u(0u));
  }
  if (creased.copy == NO_POINT) {
    return;
  }
  for (var k = 0u; k < length; k++) {
    add_triangle(select(more + k - own, creased.triangle + k, k < own), around(creased, row, k));
  }
}

fn add_triangle(at: u32, corners: vec3u) {
  for (var k = 0u; k < 3u; k++) {
    indices[3u * at + k] = corners[k];
  }
}

// on the rim edge from vertex k of the loop to the next
fn around(creased: CreasedLoop, row: vec4u, k: u32) -> vec3u {
  let a = vertex_of(creased, k);
  let b = vertex_of(creased, k + 1u);
  let branch = normals[a].w;
  let tip = copy_on(creased, branch);
  if (branch == normals[b].w) {
    return vec3u(tip, a, b);
  }
  let face = face_of(creased, row, k);
  let other = loop_across(creased, face, a, b);
  if (other == NO_LOOP || creased_loops[other].copy == NO_POINT || is_second(creased, row, k, face, other)) {
    return vec3u(tip, a, b);
  }
  return vec3u(tip, a, copy_on(creased_loops[other], branch));
}

// Whether another edge on that face is turned between the same two loops: a second one would be in the same place.
fn is_second(creased: CreasedLoop, row: vec4u, k: u32, face: vec4i, other: u32) -> bool {
  let least = min(vertex_of(creased, k), vertex_of(creased, k + 1u));
  for (var j = 0u; j < ring_length(creased); j++) {
    let a = vertex_of(creased, j);
    let b = vertex_of(creased, j + 1u);
    if (min(a, b) < least && normals[a].w != normals[b].w && all(face_of(creased, row, j) == face)
        && loop_across(creased, face, a, b) == other) {
      return true;
    }
  }
  return false;
}

// From the cell of a loop to that across the face that edge k of the loop lies on.
fn face_of(creased: CreasedLoop, row: vec4u, k: u32) -> vec4i {
  let start = loop_start(row, loop_number(creased));
  let length = ring_length(creased);
  let one = loop_edge(row, start + k % length);
  let two = loop_edge(row, start + (k + 1u) % length);
  for (var axis = 0u; axis < 3u; axis++) {
    if (axis != one.w && axis != two.w && one[axis] == two[axis]) {
      let way = select(-1, 1, one[axis] == 1u);
      return vec4i(select(vec3i(0), vec3i(way), vec3u(0u, 1u, 2u) == vec3u(axis)), 0);
    }
  }
  return vec4i(0);
}

// The loop around a crease that has the edge from b to a.
fn loop_across(creased: CreasedLoop, face: vec4i, a: u32, b: u32) -> u32 {
  let place = 4u * brick_place(lists[creased.cell / 64u]) + cell_place(creased.cell % 64u);
  let there = vec3i(place) + face.xyz;
  if (any(there < vec3i(0)) || any(there >= 4 * vec3i(lattice.bricks.xyz))) {
    return NO_LOOP;
  }
  let at = vec3u(there);
  let brick = at / 4u;
  let number = grid[brick.x + lattice.bricks.x * (brick.y + lattice.bricks.y * brick.z)];
  if (number < 0) {
    return NO_LOOP;
  }
  let cell = cells[64u * u32(number) + dot(at % 4u, vec3u(1u, 4u, 16u))];
  if ((cell.x & 65535u) == 0u) {
    return NO_LOOP;
  }
  let crossed = before[number].y + (cell.x >> 16u);
  var end = state.creased_loops;
  if (crossed + 1u < state.counts.y) {
    end = ring_counts[crossed + 1u].x;
  }
  for (var i = ring_counts[crossed].x; i < end; i++) {
    let other = creased_loops[i];
    for (var k = 0u; k < ring_length(other); k++) {
      if (vertex_of(other, k) == b && vertex_of(other, k + 1u) == a) {
        return i;
      }
    }
  }
  return NO_LOOP;
}

fn loop_number(creased: CreasedLoop) -> u32 {
  return (creased.row >> 16u) & 255u;
}

fn vertex_of(creased: CreasedLoop, k: u32) -> u32 {
  var ring = creased.ring;
  return ring[k % ring_length(creased)];
}

// the vertex of the loop's point on a side
fn copy_on(creased: CreasedLoop, branch: f32) -> u32 {
  var ring = creased.ring;
  var branches: array<f32, 12>;
  for (var k = 0u; k < ring_length(creased); k++) {
    branches[k] = normals[ring[k]].w;
  }
  return creased.copy + side_number(sides_of(branches, ring_length(creased)), branch);
}
