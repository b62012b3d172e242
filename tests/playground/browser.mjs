// Headless Chromium, controlled through a pipe by its DevTools protocol.
import {spawn} from 'node:child_process';

export class Browser {
  #process;
  #waiting = new Map();
  #session;
  #number = 0;
  faults = []; // the messages of the page's console, and exceptions

  static async open(chromium, profile) {
    const browser = new Browser();
    const words = ['--headless', '--no-sandbox', '--disable-gpu', '--no-first-run', '--disable-background-networking', '--disable-component-update',
      '--disable-sync', '--remote-debugging-pipe', `--user-data-dir=${profile}`];
    browser.#process = spawn(chromium, words, {stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe']});
    let rest = '';
    browser.#process.stdio[4].setEncoding('utf8').on('data', part => {
      const messages = (rest + part).split('\0');
      rest = messages.pop();
      for (const message of messages) browser.#hear(JSON.parse(message));
    });
    const {targetId} = await browser.send('Target.createTarget', {url: 'about:blank'});
    const {sessionId} = await browser.send('Target.attachToTarget', {targetId, flatten: true});
    browser.#session = sessionId;
    for (const domain of ['Page', 'Runtime', 'Log']) await browser.send(`${domain}.enable`);
    return browser;
  }

  #hear({id, method, params, result, error}) {
    const waiting = this.#waiting.get(id);
    this.#waiting.delete(id);
    if (error) waiting?.reject(new Error(error.message));
    else waiting?.resolve(result);
    if (method === 'Runtime.exceptionThrown') this.faults.push(params.exceptionDetails.exception?.description ?? params.exceptionDetails.text);
    if (method === 'Runtime.consoleAPICalled') this.faults.push(params.args.map(a => a.value ?? a.description).join(' '));
    if (method === 'Log.entryAdded') this.faults.push(params.entry.text);
  }
  send(method, params = {}) {
    const id = ++this.#number;
    const answer = new Promise((resolve, reject) => this.#waiting.set(id, {resolve, reject}));
    this.#process.stdio[3].write(JSON.stringify({id, method, params, sessionId: this.#session}) + '\0');
    return answer;
  }

  // Opens a page on a screen of this size, in light or dark mode.
  async goTo(url, {width, height, dark}) {
    await this.send('Emulation.setDeviceMetricsOverride', {width, height, deviceScaleFactor: 1, mobile: width < 600});
    await this.send('Emulation.setTouchEmulationEnabled', {enabled: width < 600, maxTouchPoints: 2});
    await this.send('Emulation.setEmulatedMedia', {features: [{name: 'prefers-color-scheme', value: dark ? 'dark' : 'light'}]});
    await this.send('Page.navigate', {url: 'about:blank'});
    await this.send('Page.navigate', {url});
  }

  // Runs a script in the page and returns its value, which may be a promise.
  async evaluate(expression) {
    const {result, exceptionDetails} = await this.send('Runtime.evaluate', {expression, awaitPromise: true, returnByValue: true});
    if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    return result.value;
  }

  // Presses a key; drags the mouse.
  async key(key) {
    for (const type of ['keyDown', 'keyUp']) await this.send('Input.dispatchKeyEvent', {type, key});
  }
  async drag([x, y], [u, v]) {
    for (const [type, at] of [['mousePressed', [x, y]], ['mouseMoved', [u, v]], ['mouseReleased', [u, v]]]) {
      await this.send('Input.dispatchMouseEvent', {type, x: at[0], y: at[1], button: 'left', buttons: 1, clickCount: 1});
    }
  }
  // Moves fingers, each through its list of places.
  async touch(...fingers) {
    const at = k => fingers.map((way, id) => ({x: way[k][0], y: way[k][1], id}));
    await this.send('Input.dispatchTouchEvent', {type: 'touchStart', touchPoints: at(0)});
    for (let k = 1; k < fingers[0].length; ++k) await this.send('Input.dispatchTouchEvent', {type: 'touchMove', touchPoints: at(k)});
    await this.send('Input.dispatchTouchEvent', {type: 'touchEnd', touchPoints: []});
  }

  async picture() {
    return Buffer.from((await this.send('Page.captureScreenshot', {captureBeyondViewport: true})).data, 'base64');
  }

  close() {
    this.#process.kill();
  }
}
