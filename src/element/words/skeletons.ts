/** Words of skeletons in the hand, and of profiles. */

export const SKELETON_WORDS = {
  show: 'Skeleton',
  of: (name: string) => `Skeleton of ${name}`,
  shown: (name: string, nodes: number) => `Skeleton of ${name}, ${nodes === 1 ? '1 node' : `${nodes} nodes`}`,
  hidden: 'Skeleton hidden',
  none: 'Select one form of a solid to see its skeleton',
  node: (node: number, of: number, radius: number) =>
    `Node ${node} of ${of}, radius ${Math.round(10 * radius) / 10} mm`,
  hint: 'Arrow keys move it 1 mm, with Shift 10 mm; plus and minus change its radius; Page Up and Page Down go to the next; Enter splits a link; Delete removes it.',
  add: 'Add a node: drag to where it goes',
  remove: 'Delete the node',
  chooseNode: 'Choose a node to delete it; Escape leaves the skeleton',
  asDrawn: 'As the strokes say',
  profile: 'Profile',
  profileOf: (name: string) => `Profile of ${name}`,
  profilePoint: (point: number, of: number) => `Thickness at ${point} of ${of}`,
  profileEven: 'Even',
  profileByHand: 'The skeleton was edited: its own radii count.',
} as const;
