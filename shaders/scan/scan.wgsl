#import scan/workgroup

// Exclusive sums of any number of items, four sums at a time: within groups, then of the groups' totals in one group, then
// both together (Blelloch 1990 in two levels). A thread goes through EACH items, one after the other.

const WIDTH = 64u;
const EACH = 16u;

@group(0) @binding(0) var<storage, read_write> items: array<vec4u>;
// of each group of items; the last: of all
@group(0) @binding(1) var<storage, read_write> totals: array<vec4u>;

@compute @workgroup_size(WIDTH)
fn scan_items(@builtin(workgroup_id) group: vec3u, @builtin(local_invocation_index) thread: u32) {
  let first = EACH * (WIDTH * group.x + thread);
  let end = min(first + EACH, arrayLength(&items));
  var own = vec4u(0u);
  for (var i = first; i < end; i++) {
    own += items[i];
  }
  var sum = scan_group(thread, own);
  for (var i = first; i < end; i++) {
    let item = items[i];
    items[i] = sum;
    sum += item;
  }
  if (thread == 0u) {
    totals[group.x] = scan_total();
  }
}

@compute @workgroup_size(WIDTH)
fn scan_totals(@builtin(local_invocation_index) thread: u32) {
  let count = arrayLength(&totals) - 1u;
  let each = (count + WIDTH - 1u) / WIDTH;
  let end = min((thread + 1u) * each, count);
  var own = vec4u(0u);
  for (var i = thread * each; i < end; i++) {
    own += totals[i];
  }
  var sum = scan_group(thread, own);
  for (var i = thread * each; i < end; i++) {
    let item = totals[i];
    totals[i] = sum;
    sum += item;
  }
  if (thread == 0u) {
    totals[count] = scan_total();
  }
}

@compute @workgroup_size(WIDTH)
fn add_totals(@builtin(workgroup_id) group: vec3u, @builtin(local_invocation_index) thread: u32) {
  let first = EACH * (WIDTH * group.x + thread);
  for (var i = first; i < min(first + EACH, arrayLength(&items)); i++) {
    items[i] += totals[group.x];
  }
}
