/** A worker's scope without a worker: what it says is kept, and it hears what it is told. */
export class FakeScope<To, From> {
  readonly heard: From[] = [];
  /** at once, with each message */
  onHeard: (message: From) => void = () => {};
  /** the worker's */
  onmessage?: (event: { readonly data: To }) => void;

  postMessage(message: From): void {
    this.heard.push(message);
    this.onHeard(message);
  }

  readonly say = (data: To): void => this.onmessage!({ data });

  /** For the next test. */
  forget(): void {
    this.heard.splice(0);
    this.onHeard = () => {};
  }
}
