// A page that is written anew at every save shows itself again; it keeps its place.
if (document.body.dataset.watched) setTimeout(() => location.reload(), 1000);
