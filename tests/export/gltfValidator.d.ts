/** What we use of Khronos' validator, which comes without types. */
declare module 'gltf-validator' {
  export interface Issue {
    readonly code: string;
    readonly message: string;
    readonly pointer?: string;
    /** 0 error, 1 warning, 2 information, 3 hint */
    readonly severity: 0 | 1 | 2 | 3;
  }
  export interface Report {
    readonly issues: { readonly messages: readonly Issue[]; readonly truncated: boolean };
  }
  export function validateBytes(data: Uint8Array, options?: { readonly maxIssues?: number }): Promise<Report>;
}
