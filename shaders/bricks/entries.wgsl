#import bricks/sumRange
#import bricks/treeRange

// The lists of a cube that is kept, as polygonize/nearList.wgsl reads them: of each sum what the cube found, a run of dropped sums in one row.

// of the cubes that are kept, in any order: a header each, then their entries
@group(0) @binding(1) var<storage, read_write> lists: array<vec4u>;

// LISTED, or which way it was dropped
fn kind_of(sum: u32) -> u32 {
  let bit = 1u << sum;
  if ((dropped_low & bit) != 0u) {
    return DROPPED_LOW;
  }
  return select(LISTED, DROPPED_HIGH, (dropped_high & bit) != 0u);
}

// from a dropped sum on: beyond the last that was dropped the same way
fn run_end(sum: u32, sums: u32) -> u32 {
  var end = sum + 1u;
  while (end < sums && kind_of(end) == kind_of(sum)) {
    end++;
  }
  return end;
}

fn rows_needed(sums: u32) -> u32 {
  var rows = 0u;
  for (var sum = 0u; sum < sums; ) {
    if (kind_of(sum) == LISTED) {
      rows += 5u + (entries[5u * sum].z + 3u) / 4u;
      sum++;
    } else {
      rows += 1u;
      sum = run_end(sum, sums);
    }
  }
  return rows;
}

fn write_entries(first: u32, sums: u32) {
  var row = first;
  for (var sum = 0u; sum < sums; ) {
    let kind = kind_of(sum);
    if (kind == LISTED) {
      write_listed(row, sum);
      row += 5u + (entries[5u * sum].z + 3u) / 4u;
      sum++;
      continue;
    }
    sum = run_end(sum, sums);
    lists[row] = vec4u(kind, sum, 0u, 0u);
    row++;
  }
}

// the numbers of the terms ascend as those of the list around do
fn write_listed(first: u32, sum: u32) {
  for (var i = 0u; i < 5u; i++) {
    lists[first + i] = entries[5u * sum + i];
  }
  let origin = origins[sum];
  var row = first + 5u;
  var four = vec4u(0u);
  var count = 0u;
  for (var i = 0u; i < origin.y; i++) {
    if (choice_at(origin.z + i) % 64u < origin.w) {
      continue;
    }
    four[count & 3u] = outer_term(origin.x, i);
    count++;
    if ((count & 3u) == 0u) {
      lists[row] = four;
      row++;
    }
  }
  if ((count & 3u) != 0u) {
    lists[row] = four;
  }
}
