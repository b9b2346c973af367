/** Files dragged over the element: a veil while they hang there, and what was dropped. */
import type { Picked } from './fileAccess.ts';

export interface DropTarget {
  /** may something be dropped now? */
  ready(): boolean;
  over(on: boolean): void;
  dropped(files: readonly Promise<Picked>[]): void;
}

/** ms: what hangs over a page says so several times a second; what was cancelled may not say that */
const SILENCE = 700;

export function watchDrop(element: HTMLElement, target: DropTarget, signal: AbortSignal): void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  const over = (on: boolean) => {
    clearTimeout(timer);
    if (on) timer = setTimeout(() => target.over(false), SILENCE);
    target.over(on);
  };
  const on = (type: 'dragenter' | 'dragover' | 'dragleave' | 'drop', answer: (event: DragEvent) => void) =>
    element.addEventListener(type, answer, { signal });
  const hang = (event: DragEvent) => {
    if (!target.ready() || !carriesFiles(event)) return;
    event.preventDefault();
    if (event.dataTransfer) event.dataTransfer.dropEffect = 'copy';
    over(true);
  };
  on('dragenter', hang);
  on('dragover', hang);
  // The veil lies over everything: what leaves it has left the element.
  on('dragleave', (event) => (event.composedPath()[0] as Element).matches('.veil') && over(false));
  on('drop', (event) => {
    over(false);
    if (!target.ready() || !carriesFiles(event)) return;
    event.preventDefault();
    const files = picked(event.dataTransfer);
    if (files.length > 0) target.dropped(files);
  });
}

const carriesFiles = ({ dataTransfer }: DragEvent) => dataTransfer?.types.includes('Files') ?? false;

/** Everything is asked for at once: after the event the list is empty. */
function picked(data: DataTransfer | null): Promise<Picked>[] {
  const items = [...(data?.items ?? [])].filter(({ kind }) => kind === 'file');
  return items.flatMap((item) => {
    const file = item.getAsFile();
    if (!file) return [];
    const handle = handleOf(item).catch(() => null);
    return [handle.then((found) => ({ file, handle: found }))];
  });
}

/** Only browsers with files that can be written back have it. */
interface HandleItem {
  getAsFileSystemHandle?(): Promise<FileSystemHandle | null>;
}

async function handleOf(item: DataTransferItem): Promise<FileSystemFileHandle | null> {
  const handle = await (item as HandleItem).getAsFileSystemHandle?.();
  return handle?.kind === 'file' ? (handle as FileSystemFileHandle) : null;
}
