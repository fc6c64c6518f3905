// Chromium with a page of the site, opened from its folder. What the page does wrong, or asks the network for, is noted.

import { createRequire } from "node:module";

/** Starts Chromium, for a page of the site. */
export async function open(name) {
  const puppeteer = createRequire(process.env.MODULES + "/")("puppeteer-core");
  // Chromium may start slowly while other lanes build.
  const browser = await puppeteer.launch({
    executablePath: process.env.CHROMIUM,
    headless: true,
    args: ["--no-sandbox"],
    timeout: 180_000,
  });
  const page = await browser.newPage();
  const faults = [];
  page.on("pageerror", (error) => faults.push(error.message));
  page.on("console", (message) => message.type() === "error" && faults.push(message.text()));
  page.on("request", (request) => /^(file|data|blob|about):/.test(request.url()) || faults.push(`asks for ${request.url()}`));
  return {
    page,
    faults,
    pictures: process.argv[2],
    site: new URL(`../site/${name}`, import.meta.url).href,
    text: (id) => page.$eval(`#${id}`, (one) => one.textContent),
    waitFor: (id, pattern) =>
      page.waitForFunction((id, source) => new RegExp(source).test(document.getElementById(id).textContent), { timeout: 60_000 }, id, pattern.source),
    click: (id) => page.click(`#${id}`),
    close: () => browser.close(),
  };
}
