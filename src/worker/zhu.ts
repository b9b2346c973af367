/** Casts Zhu et al.'s rays and ours onto the same bodies beside the page, to compare them: once, whoever wants less ends it. */
import { bindField } from '../field/bind.ts';
import { locating } from '../field/polygonize.ts';
import { comparing, ZhuBody } from '../field/zhuImage.ts';
import type { FromZhu, ToZhu } from '../field/zhuWork.ts';
import { finished } from '../math/finished.ts';

/** What this file needs of the scope of a worker, whose types cannot be there beside those of a page. */
interface Scope {
  onmessage: ((event: MessageEvent<ToZhu>) => void) | null;
  postMessage(message: FromZhu): void;
}

const scope = self as unknown as Scope;

scope.onmessage = ({ data }) => {
  try {
    compare(data);
  } catch (error) {
    scope.postMessage({ type: 'refused', message: error instanceof Error ? error.message : String(error) });
  }
};

function compare({ bodies, camera }: ToZhu): void {
  const start = performance.now();
  // refused before anything is located
  const theirs = bodies.map(({ node, placement }) => new ZhuBody(node, placement));
  const ours = bodies.map(({ node, placement, cells }) => ({
    located: finished(locating(bindField(node), cells)),
    placement,
  }));
  const compared = finished(comparing(ours, theirs, camera), (share) =>
    scope.postMessage({ type: 'progress', share }),
  );
  scope.postMessage({ type: 'compared', ...compared, milliseconds: performance.now() - start });
}
