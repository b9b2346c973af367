/** Why a model cannot be written, in one sentence. */
export class ExportError extends Error {
  override readonly name = 'ExportError';
}
