/* A prebuilt extension of JupyterLab, written by hand: it needs nothing of JupyterLab's packages, so nothing is bundled.

   https://jupyterlab.readthedocs.io/en/stable/extension/extension_dev.html */
(() => {
  const style = new URL('style.css', document.currentScript.src);
  const plugin = {
    id: 'ros2-course:style',
    description: 'Pictures and tables of the course stay inside of a narrow pane.',
    autoStart: true,
    activate: () => {
      const link = document.createElement('link');
      link.rel = 'stylesheet';
      link.href = style.href;
      document.head.append(link);
    },
  };
  // The container of webpack's module federation, as JupyterLab looks for it.
  window._JUPYTERLAB = window._JUPYTERLAB || {};
  window._JUPYTERLAB['ros2-course'] = {
    init: async () => {},
    get: async () => () => ({ __esModule: true, default: plugin }),
  };
})();
