/** Where in a tree something was refused: each level on the way out puts its own place before the message. */
import { FieldError } from './skeleton.ts';

/** Puts the place before what is refused inside: `parts[1].node: …` */
export function at<T>(place: string, make: () => T): T {
  try {
    return make();
  } catch (error) {
    if (!(error instanceof FieldError) || place === '') throw error;
    const separator = /^[\w.[\]]+: /.test(error.message) ? '.' : ': ';
    throw new FieldError(`${place}${separator}${error.message}`);
  }
}
