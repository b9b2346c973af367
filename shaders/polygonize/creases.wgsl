#import polygonize/creased
#import polygonize/creaseNear
#import polygonize/state

// The point of each loop that is around a crease or a corner, with a vertex for each side. Twin of src/field/loopPoints.ts.

@group(0) @binding(1) var<storage, read_write> creased_loops: array<CreasedLoop>;
@group(0) @binding(2) var<storage, read_write> positions: array<vec4f>;
// and the branch; of points on creases − 2 − the loop
@group(0) @binding(3) var<storage, read_write> normals: array<vec4f>;
@group(0) @binding(4) var<storage, read_write> colours: array<vec4f>;

// sine of an angle: what is turned by less is flat
const TURNED = 0.05;

@compute @workgroup_size(64)
fn creases(
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
  var ring = creased.ring;
  var branches: array<f32, 12>;
  var middle = vec3f(0.0);
  for (var k = 0u; k < length; k++) {
    branches[k] = normals[ring[k]].w;
    middle += positions[ring[k]].xyz / f32(length);
  }
  let sides = sides_of(branches, length);
  var side_branches = sides.branches;
  let point = crease_near(lists[creased.cell / 64u].y, sides, middle);
  if (point.w == 0.0 || is_turned(creased, branches, sides, point.xyz)) {
    creased_loops[i].copy = NO_POINT;
    return;
  }
  for (var side = 0u; side < sides.count; side++) {
    var colour = vec4f(0.0);
    for (var k = 0u; k < length; k++) {
      colour += select(vec4f(0.0), colours[ring[k]], branches[k] == side_branches[side]);
    }
    let vertex = creased.copy + side;
    positions[vertex] = vec4f(point.xyz, 1.0);
    normals[vertex] = vec4f(side_normals[side], -2.0 - f32(i));
    colours[vertex] = colour / max(colour.w, 1.0);
  }
}

// Whether a triangle around the point would be seen from within: of blades too thin for the lattice the tip is behind the loop.
fn is_turned(creased: CreasedLoop, ring_branches: array<f32, 12>, sides: Sides, at: vec3f) -> bool {
  var ring = creased.ring;
  var branches = ring_branches;
  let length = ring_length(creased);
  for (var k = 0u; k < length; k++) {
    let next = (k + 1u) % length;
    if (branches[k] != branches[next]) {
      continue;
    }
    let p = positions[ring[k]].xyz - at;
    let q = positions[ring[next]].xyz - at;
    let normal = side_normals[side_number(sides, branches[k])];
    if (dot(cross(p, q), normal) < -TURNED * sqrt(dot(p, p) * dot(q, q))) {
      return true;
    }
  }
  return false;
}
