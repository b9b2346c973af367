#import polygonize/lattice

// What lies on a border between bricks belongs to the active one with the lowest number among those that hold it: two bricks ask different
// skels and would disagree.

// of all bricks: number among the active ones, or −1, all outside, or −2, all inside
@group(0) @binding(0) var<storage, read> grid: array<i32>;

struct Owner {
  // −1: none
  number: i32,
  place: vec3u,
  // of bricks without surface that hold it too: 1 inside, −1 outside, 0 none
  sign: i32,
}

fn owner_of_node(n: vec3u) -> Owner {
  let last = lattice.bricks.xyz - 1u;
  return owner_among((max(n, vec3u(1u)) - 1u) / 4u, min(n / 4u, last));
}

// from node n to the next along an axis
fn owner_of_edge(n: vec3u, axis: u32) -> Owner {
  let last = lattice.bricks.xyz - 1u;
  let low = select((max(n, vec3u(1u)) - 1u) / 4u, n / 4u, vec3u(0u, 1u, 2u) == vec3u(axis));
  return owner_among(low, min(n / 4u, last));
}

fn owner_among(low: vec3u, high: vec3u) -> Owner {
  var owner = Owner(-1, vec3u(0u), 0);
  for (var z = low.z; z <= high.z; z++) {
    for (var y = low.y; y <= high.y; y++) {
      for (var x = low.x; x <= high.x; x++) {
        let number = grid[x + lattice.bricks.x * (y + lattice.bricks.y * z)];
        if (number < 0) {
          owner.sign = select(-1, 1, number == -2);
        } else if (owner.number < 0) {
          owner.number = number;
          owner.place = vec3u(x, y, z);
        }
      }
    }
  }
  return owner;
}
