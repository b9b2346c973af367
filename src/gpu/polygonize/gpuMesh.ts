/** A mesh that lives on the GPU: how large it is only the device knows until it is asked. */
import type { FieldMesh } from '../../field/brickMesh.ts';
import { COUNTERS, type LevelRoom, neededRooms, overflows, workOf } from '../bricks/levels.ts';
import { type Buffers, type readBack, type Slice, USAGE } from './buffers.ts';
import { creasedMesh } from './creasedMesh.ts';

/** How much there is room for. */
export interface Capacity {
  readonly vertices: number;
  readonly triangles: number;
}

export interface Needed extends Capacity {
  /** cubes and entries of each level of bricks that the device culls, where it did */
  readonly bricks: readonly LevelRoom[];
  /** what that took with all that came after, in values of one skel at one point, nearly; 0 for bricks that were given */
  readonly work: number;
}

export interface GpuMesh {
  /** vec4f a vertex: x, y, z in mm, 1 */
  readonly positions: GPUBuffer;
  /** vec4f a vertex: unit, outward, and a number of the stages' own */
  readonly normals: GPUBuffer;
  /** vec4f a vertex: red, green, blue (0–1, linear), 1 */
  readonly colours: GPUBuffer;
  /** u32, three a triangle, counter-clockwise from outside */
  readonly indices: GPUBuffer;
  /** for drawIndexedIndirect; nothing is drawn of what did not fit */
  readonly draw: GPUBuffer;
  /** what the buffers hold at most */
  readonly room: Capacity;
  /** Whether there was not room enough: the mesh is empty then. */
  overflowed(): Promise<boolean>;
  /** How large it is, or would have to be; of bricks that there was no room for only these are known. */
  needed(): Promise<Needed>;
  /** All of it, without what was counted for points on creases that are none. Rejects for one that overflowed. */
  read(): Promise<FieldMesh>;
  /** Gives the buffers to meshes that come later. */
  destroy(): void;
}

/** Where the stages write it. */
export interface Outputs {
  readonly positions: Slice;
  readonly normals: Slice;
  readonly colours: Slice;
  readonly indices: Slice;
  readonly draw: Slice;
  /** as State in shaders/polygonize/state.wgsl */
  readonly state: Slice;
  /** of bricks that the device culls: cubes and rows of each level */
  readonly counters: Slice;
}

export function outputs(buffers: Buffers, { vertices, triangles }: Capacity): Outputs {
  const shared = USAGE.storage | USAGE.copySource | USAGE.copyTarget;
  const wide = (name: string) => buffers.get(name, 16 * vertices, shared | USAGE.vertex);
  return {
    positions: wide('positions'),
    normals: wide('normals'),
    colours: wide('colours'),
    indices: buffers.get('indices', 12 * triangles, shared | USAGE.index),
    draw: buffers.get('draw', 20, shared | USAGE.indirect),
    state: buffers.get('state', 32, shared | USAGE.uniform),
    counters: buffers.put('counters', new Uint32Array(COUNTERS), shared),
  };
}

/** `read`: bytes of buffers, or why there are none. `rooms`: of the levels of bricks, where the device culls. */
export function gpuMesh(
  { positions, normals, colours, indices, draw, state, counters: counts }: Outputs,
  read: (slices: readonly Slice[]) => ReturnType<typeof readBack>,
  giveBack: () => void,
  rooms: readonly LevelRoom[] = [],
): GpuMesh {
  let isGone = false;
  const found = async () => {
    if (isGone) throw new Error('the mesh was given back');
    const [bytes, counted] = await read([state, counts]);
    const [edges, , triangles, middles, overflow, loops, copies] = new Uint32Array(bytes!);
    const counters = new Uint32Array(counted!);
    const bricks = neededRooms(counters);
    const vertices = edges! + middles! + copies!;
    return {
      vertices,
      // two more around each point than in its loop
      triangles: triangles! + 2 * loops!,
      hasCreases: loops! > 0,
      bricks,
      work: workOf(counters, vertices),
      overflowed: overflow !== 0 || overflows(rooms, bricks),
    };
  };
  return {
    positions: positions.buffer,
    normals: normals.buffer,
    colours: colours.buffer,
    indices: indices.buffer,
    draw: draw.buffer,
    room: { vertices: Math.floor(positions.size / 16), triangles: Math.floor(indices.size / 12) },
    overflowed: async () => (await found()).overflowed,
    needed: found,
    async read() {
      const { vertices, triangles, hasCreases, overflowed } = await found();
      if (overflowed) throw new Error('the mesh did not fit into its buffers');
      const wide = [positions, normals, colours].map((slice) => ({ ...slice, size: 16 * vertices }));
      const bytes = await read([...wide, { ...indices, size: 12 * triangles }]);
      const [at, normal, colour] = bytes.slice(0, 3).map((four) => threeOfFour(new Float32Array(four)));
      const indices32 = new Uint32Array(bytes[3]!);
      const whole = { positions: at!, normals: normal!, colours: colour!, indices: indices32 };
      const fans = new Float32Array(bytes[1]!).filter((_, i) => i % 4 === 3);
      const mesh = hasCreases ? creasedMesh({ ...whole, fans }) : whole;
      return { ...mesh, uvs: new Float32Array((2 * mesh.positions.length) / 3) };
    },
    destroy() {
      if (!isGone) giveBack();
      isGone = true;
    },
  };
}

function threeOfFour(wide: Float32Array): Float32Array {
  const narrow = new Float32Array((wide.length / 4) * 3);
  for (let i = 0, k = 0; i < wide.length; i += 4, k += 3) {
    narrow[k] = wide[i]!;
    narrow[k + 1] = wide[i + 1]!;
    narrow[k + 2] = wide[i + 2]!;
  }
  return narrow;
}
