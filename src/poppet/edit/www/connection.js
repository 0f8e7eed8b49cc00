/* Requests to the server of the editor. */

import { text } from "./strings.js";

/* The server does not answer. */
export class ConnectionLost extends Error {}

/* Send a GET request, or a POST request with a JSON body or a typed array; return the status and the body of the reply. */
export async function request(path, body) {
  const options = { cache: "no-store", credentials: "same-origin" };
  if (body !== undefined) {
    const isBytes = ArrayBuffer.isView(body);
    const headers = { "Content-Type": isBytes ? "application/octet-stream" : "application/json" };
    Object.assign(options, { method: "POST", headers, body: isBytes ? body : JSON.stringify(body) });
  }
  try {
    const reply = await fetch(path, options);
    const isJson = (reply.headers.get("Content-Type") ?? "").startsWith("application/json");
    return { status: reply.status, body: isJson ? await reply.json() : await reply.arrayBuffer() };
  } catch (problem) {
    throw new ConnectionLost(path, { cause: problem });
  }
}

/* As `request`; if the server does not answer, the reply has an error that says so. */
export async function attempt(path, body) {
  try {
    return await request(path, body);
  } catch {
    return { status: 0, body: { state: "lost", errors: [{ code: "", address: "", line: null, message: text("problems.lost"), hint: "" }] } };
  }
}

/* True if an error keeps the circuit from running; those of the table `modbus` do not. */
export const concernsRun = error => error.concerns_run !== false;

/* Return the errors of a reply that is not a success. */
export function errorsOf({ status, body }) {
  if (Array.isArray(body?.errors) && body.errors.length) return body.errors;
  return [{ code: "", address: "", line: null, message: body?.message ?? `HTTP ${status}`, hint: "" }];
}
