// Sums within a group of WIDTH threads, which the importer says: for each thread those before it. Four sums at a time, in two levels
// of 16, for barriers are dear on software adapters: a ladder of log₂ WIDTH steps took ten times as long. To be called by all threads.

var<workgroup> scan_own: array<vec4u, WIDTH>;
var<workgroup> scan_rows: array<vec4u, WIDTH / 16u>;

fn scan_group(thread: u32, own: vec4u) -> vec4u {
  scan_own[thread] = own;
  workgroupBarrier();
  var before = vec4u(0u);
  for (var i = thread & ~15u; i < thread; i++) {
    before += scan_own[i];
  }
  if ((thread & 15u) == 15u) {
    scan_rows[thread / 16u] = before + own;
  }
  workgroupBarrier();
  for (var row = 0u; row < thread / 16u; row++) {
    before += scan_rows[row];
  }
  return before;
}

// of all threads, after scan_group
fn scan_total() -> vec4u {
  var total = vec4u(0u);
  for (var row = 0u; row < WIDTH / 16u; row++) {
    total += scan_rows[row];
  }
  return total;
}
