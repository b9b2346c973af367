// All records of a field, of whatever kind, each at a multiple of 16 bytes: one binding of the eight that WebGPU promises.
@group(1) @binding(0) var<storage, read> records: array<vec4u>;
