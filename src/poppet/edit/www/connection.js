/* Requests to the server of the editor. */

/* The server does not answer. */
export class ConnectionLost extends Error {}

/* Send a GET request, or a POST request with a JSON body; return the status and the body of the reply. */
export async function request(path, body) {
  const options = { cache: "no-store", credentials: "same-origin" };
  if (body !== undefined) {
    Object.assign(options, { method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify(body) });
  }
  try {
    const reply = await fetch(path, options);
    const isJson = (reply.headers.get("Content-Type") ?? "").startsWith("application/json");
    return { status: reply.status, body: isJson ? await reply.json() : await reply.arrayBuffer() };
  } catch (problem) {
    throw new ConnectionLost(path, { cause: problem });
  }
}

/* Return the errors of a reply that is not a success. */
export function errorsOf({ status, body }) {
  if (Array.isArray(body?.errors) && body.errors.length) return body.errors;
  return [{ code: "", address: "", line: null, message: body?.message ?? `HTTP ${status}`, hint: "" }];
}
