/** What keeps a command from doing what was asked, in words for the person who asked. */
export class Problem extends Error {
  override readonly name = 'Problem';
  /** 2: what was asked or given is at fault; 1: the machine is */
  readonly status: 1 | 2;

  constructor(message: string, status: 1 | 2 = 2) {
    super(message);
    this.status = status;
  }
}

/** A problem of the file system, in words. */
export function fileProblem(path: string, doing: string, error: unknown): Problem {
  const code = (error as { code?: unknown } | null)?.code;
  // The folder was there a moment ago.
  const folder = code === 'ENOENT' && doing === 'written' ? 'its folder takes no files' : null;
  const reason = folder ?? ((typeof code === 'string' && REASONS[code]) || String(code ?? error));
  return new Problem(`${path}: cannot be ${doing}: ${reason}`);
}

const REASONS: Readonly<Record<string, string>> = {
  ENOENT: 'there is no such file',
  EACCES: 'permission denied',
  EPERM: 'permission denied',
  EISDIR: 'it is a folder',
  ENOTDIR: 'a part of the path is a file, not a folder',
  ENOSPC: 'no space is left',
  EDQUOT: 'no space is left',
  EROFS: 'the disk is read-only',
  ENAMETOOLONG: 'the name is too long',
  ELOOP: 'its links go round in circles',
};
