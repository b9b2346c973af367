/**
 * The start-up self-test: one compute pass and one small draw with known results, read back and compared bit
 * for bit (every expected number is exact in float32 and in 8 bits). Costs 2–5 ms on a graphics card, about
 * 60 ms on a software adapter.
 */
import source from '../../shaders/lib/selfTest.wgsl?raw';

/** numbers written by the compute pass, one per thread of its workgroup */
const NUMBERS = 64;
/** pixels a side of the drawn texture */
const SIDE = 16;
/** bytes; the least row pitch WebGPU copies with */
const ROW = 256;

/** What of the device is used for one question, all of it to be given back. */
interface Asked {
  readonly answer: GPUBuffer;
  readonly used: readonly (GPUBuffer | GPUTexture)[];
}

/** Returns what went wrong, or null when the device computes and draws as it should. */
export async function selfTest(device: GPUDevice): Promise<string | null> {
  device.pushErrorScope('validation');
  const encoder = device.createCommandEncoder({ label: 'self-test' });
  const module = device.createShaderModule({ label: 'lib/selfTest.wgsl', code: source });
  const numbers = encodeCompute(device, encoder, module);
  const picture = encodeDraw(device, encoder, module);
  device.queue.submit([encoder.finish()]);
  const error = await device.popErrorScope();
  try {
    if (error) return error.message;
    return wrongNumber(await read(numbers.answer)) ?? wrongPixel(await read(picture.answer));
  } finally {
    for (const resource of [...numbers.used, ...picture.used]) resource.destroy();
  }
}

function encodeCompute(device: GPUDevice, encoder: GPUCommandEncoder, module: GPUShaderModule): Asked {
  const size = NUMBERS * Float32Array.BYTES_PER_ELEMENT;
  const storage = device.createBuffer({ label: 'self-test numbers', size, usage: 0x80 | 0x4 });
  const pipeline = device.createComputePipeline({
    label: 'self-test numbers',
    layout: 'auto',
    compute: { module, entryPoint: 'compute_numbers' },
  });
  const pass = encoder.beginComputePass({ label: 'self-test numbers' });
  pass.setPipeline(pipeline);
  const bindings = device.createBindGroup({
    label: 'self-test numbers',
    layout: pipeline.getBindGroupLayout(0),
    entries: [{ binding: 0, resource: { buffer: storage } }],
  });
  pass.setBindGroup(0, bindings);
  pass.dispatchWorkgroups(1);
  pass.end();
  const readable = readableBuffer(device, 'self-test numbers, read back', size);
  encoder.copyBufferToBuffer(storage, 0, readable, 0, size);
  return { answer: readable, used: [storage, readable] };
}

function encodeDraw(device: GPUDevice, encoder: GPUCommandEncoder, module: GPUShaderModule): Asked {
  const format = 'rgba8unorm';
  const texture = device.createTexture({
    label: 'self-test picture',
    size: [SIDE, SIDE],
    format,
    usage: 0x11,
  });
  const pipeline = device.createRenderPipeline({
    label: 'self-test picture',
    layout: 'auto',
    vertex: { module, entryPoint: 'cover' },
    fragment: { module, entryPoint: 'colour_by_place', targets: [{ format }] },
  });
  const view = texture.createView({ label: 'self-test picture' });
  const pass = encoder.beginRenderPass({
    label: 'self-test picture',
    colorAttachments: [{ view, loadOp: 'clear', storeOp: 'store' }],
  });
  pass.setPipeline(pipeline);
  pass.draw(3);
  pass.end();
  const readable = readableBuffer(device, 'self-test picture, read back', ROW * SIDE);
  encoder.copyTextureToBuffer({ texture }, { buffer: readable, bytesPerRow: ROW }, [SIDE, SIDE]);
  return { answer: readable, used: [texture, readable] };
}

// GPUBufferUsage and GPUTextureUsage are globals of browsers only, hence the numbers of the standard here:
// buffers: MAP_READ 1, COPY_SRC 4, COPY_DST 8, STORAGE 0x80; textures: COPY_SRC 1, RENDER_ATTACHMENT 0x10.
function readableBuffer(device: GPUDevice, label: string, size: number): GPUBuffer {
  return device.createBuffer({ label, size, usage: 0x1 | 0x8 });
}

async function read(buffer: GPUBuffer): Promise<ArrayBuffer> {
  // GPUMapMode.READ
  await buffer.mapAsync(1);
  return buffer.getMappedRange();
}

function wrongNumber(bytes: ArrayBuffer): string | null {
  const numbers = new Float32Array(bytes);
  for (let i = 0; i < NUMBERS; i++) {
    const expected = (NUMBERS - 1 - i) ** 2 + 0.5;
    if (numbers[i] !== expected) return `computed ${numbers[i]} in place of ${expected}`;
  }
  return null;
}

function wrongPixel(bytes: ArrayBuffer): string | null {
  const pixels = new Uint8Array(bytes);
  for (let y = 0; y < SIDE; y++) {
    for (let x = 0; x < SIDE; x++) {
      const at = y * ROW + 4 * x;
      const [red, green, blue] = pixels.subarray(at, at + 3);
      if (red !== 16 * x || green !== 16 * y || blue !== 128) return `drew a wrong colour at ${x}, ${y}`;
    }
  }
  return null;
}
