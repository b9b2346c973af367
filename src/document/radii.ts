/** mm: what files take as radii of brushes */
export const RADII = { min: 0.1, max: 200 } as const;
