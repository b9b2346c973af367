#import record/level

// One level of cubes, from large to small: of how many bricks along, and where its lists lie.

@group(0) @binding(9) var<uniform> level: Level;

const OUTSIDE = -1;
const INSIDE = -2;

// of counters: cubes and rows of each level
fn cubes_of(number: u32) -> u32 {
  return 2u * number;
}

fn rows_of(number: u32) -> u32 {
  return 2u * number + 1u;
}
