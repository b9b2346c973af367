/**
 * Files of a person: opened and saved through the browser's own dialogs where it has them, so that saving again writes
 * the same file; elsewhere through a file input and downloads.
 */
import { type FileWithHandle, fileOpen, fileSave, supported } from 'browser-fs-access';

export const EXTENSIONS = ['.rotund', '.json'] as const;

/** of a `.rotund` file; it is JSON, but a person should not have to know */
const MIME = 'application/json';

const OPTIONS = { description: 'Rotund drawing', mimeTypes: [MIME], id: 'rotund' };

/** What a person opened: the file, and the way back to it where there is one. */
export interface Picked {
  readonly file: File;
  readonly handle: FileSystemFileHandle | null;
}

/** Null when the person chose none. */
export async function pick(): Promise<Picked | null> {
  // Systems that know no such extension grey these files out: there, any file may be chosen.
  const filter = supported || !isApple() ? { extensions: [...EXTENSIONS] } : { mimeTypes: [] };
  const file: FileWithHandle | null =
    (await fileOpen({ ...OPTIONS, ...filter }).catch(unlessCancelled)) ?? null;
  return file && { file, handle: file.handle ?? null };
}

const isApple = () => /^(iP|Mac)/.test(navigator.platform) && navigator.maxTouchPoints > 1;

export type Saved =
  | { readonly way: 'cancelled' }
  | { readonly way: 'download' }
  | { readonly way: 'file'; readonly handle: FileSystemFileHandle };

/** To the file of the handle; without one, where the person says. `name` has its extension. */
export async function save(text: string, name: string, handle: FileSystemFileHandle | null): Promise<Saved> {
  const blob = new Blob([text], { type: MIME });
  const options = { ...OPTIONS, mimeTypes: [MIME], extensions: [EXTENSIONS[0]], fileName: name };
  const kept = await fileSave(blob, options, handle).catch(unlessCancelled);
  if (kept === undefined) return { way: 'cancelled' };
  return kept ? { way: 'file', handle: kept } : { way: 'download' };
}

function unlessCancelled(error: unknown): undefined {
  if (error instanceof DOMException && error.name === 'AbortError') return;
  throw error;
}

/** One file after the other into the folder for downloads. */
export function download(files: readonly { readonly name: string; readonly blob: Blob }[]): void {
  for (const { name, blob } of files) {
    const link = document.createElement('a');
    link.download = name;
    link.href = URL.createObjectURL(blob);
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
  }
}
