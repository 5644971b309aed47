// The way to a server that has a token: every request carries it, and waits while it is being asked for.

import { createStore, type Store } from "../model/store";

export interface AccessState {
  /** The server wants a token that it has not been given. */
  isWanted: boolean;
  /** What was given last was not it. */
  isWrong: boolean;
  /** Too many wrong ones were given: for a while the server says nothing else. */
  isLocked: boolean;
}

export const access: Store<AccessState> = createStore<AccessState>({
  isWanted: false,
  isWrong: false,
  isLocked: false,
});

const UNAUTHORIZED = 401;
const TOO_MANY_WRONG = 429;
/** Of this tab, for as long as it is open. */
const KEY = "dini.token";
const WRONG_CODE = "too-many-wrong-tokens";

let token: string | null = stored();

/** Takes a token into use and lets the requests go that wait for one. */
export function giveToken(given: string): void {
  token = given;
  try {
    sessionStorage.setItem(KEY, given);
  } catch {
    // It is asked for again after a reload.
  }
  access.set({ isWanted: false });
}

/**
 * As fetch, with the token. A request that is refused for want of one is sent again once it has been given; `longest`
 * milliseconds are what the server has for its answer, not what a person has for finding the token.
 */
export async function send(address: string, request: RequestInit = {}, longest?: number): Promise<Response> {
  for (;;) {
    await given(request.signal ?? undefined);
    const used = token;
    const headers = new Headers(request.headers);
    if (used !== null) headers.set("authorization", `Bearer ${used}`);
    const signal = longest === undefined ? request.signal : AbortSignal.timeout(longest);
    const response = await fetch(address, { ...request, headers, signal });
    if (!(await isRefused(response))) return response;
    // Another request may have learned of it meanwhile, and been given a new one.
    if (token === used)
      access.set({ isWanted: true, isWrong: used !== null, isLocked: response.status !== UNAUTHORIZED });
  }
}

async function isRefused(response: Response): Promise<boolean> {
  if (response.status === UNAUTHORIZED) return true;
  if (response.status !== TOO_MANY_WRONG) return false;
  return (await response.clone().text()).includes(WRONG_CODE);
}

/** Resolves when no token is asked for; rejects when the request is given up. */
function given(signal: AbortSignal | undefined): Promise<void> {
  if (!access.get().isWanted) return Promise.resolve();
  return new Promise((done, fail) => {
    const end = (): void => {
      stop();
      signal?.removeEventListener("abort", giveUp);
    };
    const giveUp = (): void => {
      end();
      fail(signal?.reason);
    };
    const stop = access.subscribe(() => {
      if (access.get().isWanted) return;
      end();
      done();
    });
    signal?.addEventListener("abort", giveUp);
  });
}

function stored(): string | null {
  try {
    return typeof sessionStorage === "undefined" ? null : sessionStorage.getItem(KEY);
  } catch {
    return null;
  }
}
