// The live book of `rotatebook watch`: plays what the script `file` says, which is read again and again.

const kFollowPause = 150;  // [ms]

function follow(file) {
  let last = "";
  const bytesOf = (letters) => Uint8Array.from(letters, (letter) => letter.codePointAt(0));

  window.rotatebookFollows = (content) => {
    const now = JSON.stringify(content);
    if (now === last) return;
    last = now;
    const {player} = window.rotatebook, {text, files, problem} = content;
    if (problem) {
      player.announcer.show(problem, "bad");
      return;
    }
    const isFirst = player.loaded.isOpening, view = {...player.orbit};
    player.files.take(files.map(({name, letters}) => ({name, bytes: bytesOf(letters)})));
    // What is looked at stays: the moment, and from where.
    player.load(text, isFirst ? {isPlaying: player.mayMove} : {frame: player.frame, isPlaying: player.isPlaying});
    Object.assign(player.orbit, view);
    player.redraw();
  };

  const look = () => {
    const script = document.createElement("script");
    script.src = `${encodeURIComponent(file)}?${Date.now()}`;
    script.onload = script.onerror = () => {
      script.remove();
      setTimeout(look, kFollowPause);
    };
    document.head.append(script);
  };

  if (window.rotatebook) look();
  else document.addEventListener("rotatebook-live", () => { if (window.rotatebook) look(); }, {once: true});
}
