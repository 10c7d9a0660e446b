// SPDX-License-Identifier: BSD-3-Clause
// Who the reader is. A link such as http://host:8080/#token=… brings the token; it is kept for this
// tab alone, and leaves the address bar at once: the fragment is never sent, but would be copied.

const KEY = "galilean.token";

interface Place {
  readonly hash: string;
  readonly pathname: string;
  readonly search: string;
}

/** Takes a token from the address, if one is there; the token that counts from now on. */
export function takeToken(place: Place, storage: Pick<Storage, "getItem" | "setItem">, clear: (address: string) => void): string {
  const given = new URLSearchParams(place.hash.slice(1)).get("token");
  if (given) {
    storage.setItem(KEY, given);
    clear(place.pathname + place.search);
  }
  return given ?? storage.getItem(KEY) ?? "";
}

export const token =
  typeof location === "undefined" ? "" : takeToken(location, sessionStorage, (address) => history.replaceState(null, "", address));

/** What a request must carry. */
export function credentials(): Record<string, string> {
  return token ? { authorization: `Bearer ${token}` } : {};
}

/** A WebSocket cannot carry a header: there the token stands in the query. */
export function withToken(url: string): string {
  return token ? `${url}${url.includes("?") ? "&" : "?"}token=${encodeURIComponent(token)}` : url;
}
