/* A prebuilt extension of JupyterLab, written by hand: it bundles nothing, and takes JupyterLab's own packages from the
   scope that they share. https://jupyterlab.readthedocs.io/en/stable/extension/extension_dev.html */
(() => {
  const here = document.currentScript.src;
  let scope = {};

  const style = {
    id: 'ros2-course:style',
    description: 'Pictures and tables stay inside of a narrow pane.',
    autoStart: true,
    activate: () => {
      const link = document.createElement('link');
      link.rel = 'stylesheet';
      link.href = new URL('style.css', here).href;
      document.head.append(link);
    },
  };

  async function shared(name) {
    const versions = Object.values(scope[name]);
    return (await (versions.find((version) => version.loaded) ?? versions[0]).get())();
  }

  async function plugins() {
    try {
      const { answers } = await import(new URL('answers.js', here).href);
      return [style, await answers(shared)];
    } catch (error) {
      console.warn('ros2-course: cells with files are coloured as Python', error);
      return [style];
    }
  }

  // The container of webpack's module federation, as JupyterLab looks for it.
  window._JUPYTERLAB = window._JUPYTERLAB || {};
  window._JUPYTERLAB['ros2-course'] = {
    init: async (given) => {
      scope = given;
    },
    get: async () => {
      const found = await plugins();
      return () => ({ __esModule: true, default: found });
    },
  };
})();
