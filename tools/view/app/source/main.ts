// A page has its bundle inside; without one, a session is behind it.
import { bundleOfText } from "./bundle";
import { byId, say } from "./dom";
import { showPage } from "./page";
import { startSession } from "./session";

async function start(): Promise<void> {
  const data = document.getElementById("bundle");
  if (data) {
    showPage(bundleOfText(data.textContent ?? ""));
    data.remove();
  } else {
    await startSession();
  }
}

byId("status").textContent = "Loading";
start().catch((error: unknown) => say(error instanceof Error ? error.message : String(error), true));
