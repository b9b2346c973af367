// Loops around creases, as stages hand them on.

struct CreasedLoop {
  // 64 · brick + cell
  cell: u32,
  // of the loop table; 16 bits, then 8 of the loop's number in it and 8 of its length
  row: u32,
  // the first that it would have without a crease; two more are behind those of all loops
  triangle: u32,
  // first of its vertices on the crease, one a side, or NO_POINT
  copy: u32,
  // vertices, counter-clockwise from outside
  ring: array<u32, 12>,
}

const NO_POINT = 0xffffffffu;

fn ring_length(creased: CreasedLoop) -> u32 {
  return creased.row >> 24u;
}

// Sides of a loop: the branches of its vertices, each once, ascending.
struct Sides {
  branches: array<f32, 12>,
  // vertices on each
  vertices: array<u32, 12>,
  // 0 where that of a vertex is not known
  count: u32,
}

// `branches`: of the ring's vertices
fn sides_of(branches: array<f32, 12>, length: u32) -> Sides {
  var all = branches;
  var sides: Sides;
  var last = -1.0;
  for (var k = 0u; k < length; k++) {
    if (all[k] < 0.0) {
      sides.count = 0u;
      return sides;
    }
  }
  loop {
    var next = 3e38;
    for (var k = 0u; k < length; k++) {
      next = select(next, min(next, all[k]), all[k] > last);
    }
    if (next == 3e38) {
      return sides;
    }
    sides.branches[sides.count] = next;
    for (var k = 0u; k < length; k++) {
      sides.vertices[sides.count] += u32(all[k] == next);
    }
    sides.count++;
    last = next;
  }
}

fn side_number(among: Sides, branch: f32) -> u32 {
  var sides = among;
  var number = 0u;
  for (var k = 0u; k < sides.count; k++) {
    number = select(number, k, sides.branches[k] == branch);
  }
  return number;
}
