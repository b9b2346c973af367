import { type Document, isSolid } from '../document.ts';
import type { Component } from '../solid.ts';
import { nameOf } from './changeParts.ts';
import type { CommandKind } from './index.ts';

export interface Data {
  /** of components, or of solids, and of groups for the component they are in */
  readonly ids: readonly string[];
  readonly change: Partial<Pick<Component, 'kernel' | 'threshold'>>;
}

/** The kernel and the threshold of sums. */
export const setComponents: CommandKind<'setComponents', Data> = {
  type: 'setComponents',
  apply(document, { ids, change }) {
    const chosen = new Set(ids);
    const parts = document.parts.map((part) => {
      if (!isSolid(part)) return part;
      const isChosen = ({ id, groups }: Component) =>
        chosen.has(part.id) || chosen.has(id) || groups.some((group) => chosen.has(group.id));
      const components = part.components.map((component) =>
        isChosen(component) ? changed(component, change) : component,
      );
      return components.every((component, i) => component === part.components[i])
        ? part
        : { ...part, components };
    });
    return parts.every((part, i) => part === document.parts[i]) ? document : { ...document, parts };
  },
  describe: (document: Document, { ids, change }) =>
    `${Object.keys(change).join(', ')} of ${nameOf(document, ids)}`,
};

function changed(component: Component, change: Data['change']): Component {
  const { kernel = component.kernel, threshold = component.threshold } = change;
  const isSame = kernel === component.kernel && threshold === component.threshold;
  return isSame ? component : { ...component, kernel, threshold };
}
