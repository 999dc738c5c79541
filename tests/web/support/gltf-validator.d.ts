/** What of Khronos's validator is used here; it comes without types. */
declare module 'gltf-validator' {
  export interface Issue {
    readonly code: string;
    readonly message: string;
    /** 0 error, 1 warning, 2 information, 3 hint. */
    readonly severity: number;
    readonly pointer?: string;
  }

  export interface Report {
    readonly issues: { readonly messages: readonly Issue[]; readonly truncated: boolean };
    readonly info?: {
      readonly totalTriangleCount: number;
      readonly totalVertexCount: number;
      readonly drawCallCount: number;
      readonly materialCount: number;
    };
  }

  interface Options {
    /** 0: any number of them. */
    readonly maxIssues?: number;
    readonly writeTimestamp?: boolean;
  }

  const validator: {
    validateBytes(data: Uint8Array, options?: Options): Promise<Report>;
    validateString(json: string, options?: Options): Promise<Report>;
  };
  export default validator;
}
