/** Words of what surfaces do with light. */

export const FINISH_WORDS = {
  finish: 'Finish',
  finishOf: (name: string) => `Finish of ${name}`,
  next: 'this and the next form',
  finishes: { clay: 'Clay', matt: 'Matt', satin: 'Satin', gloss: 'Gloss', metal: 'Metal', glow: 'Glow' },
  own: 'Own',
  more: 'More light',
  name: { ambient: 'Ambient', diffuse: 'Diffuse', specular: 'Shine', shininess: 'Shininess' },
  hint: {
    ambient: 'Light from everywhere: more of it lifts the shade',
    diffuse: 'Light from the lamp: more of it sets lit and shaded sides apart',
    specular: 'Specular: how strong the highlight is',
    shininess: 'The larger, the smaller and sharper the highlight is',
  },
} as const;
