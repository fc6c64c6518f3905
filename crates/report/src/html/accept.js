// Accepting findings: a reason for the chosen one, and the file that `twinedge audit --accept` reads.

/** Keeps what is accepted by now. A page that stands in another one leaves that to it. */
class Acceptance {
  constructor(data, list) {
    Object.assign(this, { list, chosen: null, schema: data.acceptable.schema });
    this.form = document.getElementById("accept");
    this.entries = new Map(data.acceptable.accepted.map((entry) => [entry.id, entry]));
    this.isKept = window.self === window.top && this.entries.size > 0;
    this.form.addEventListener("submit", (event) => {
      event.preventDefault();
      this.set(this.form.elements.reason.value.trim());
    });
    document.getElementById("unaccept").addEventListener("click", () => this.set(null));
    document.getElementById("save-accepted").addEventListener("click", () => this.save());
    this.show(null);
  }

  /** Offers a finding; null for none. Violations of the structure cannot be accepted. */
  show(finding) {
    this.chosen = this.isKept && finding && this.entries.has(finding.id) ? finding : null;
    this.form.hidden = !this.chosen;
    const isAccepted = (this.chosen?.accepted ?? null) !== null;
    this.form.elements.reason.value = this.chosen?.accepted ?? "";
    document.getElementById("unaccept").hidden = !isAccepted;
    const count = this.list.all.filter((one) => this.isAccepted(one)).length;
    document.getElementById("saving").hidden = !this.isKept;
    document.getElementById("accepted-count").textContent = count === 1 ? "1 finding is accepted." : `${count} findings are accepted.`;
  }

  isAccepted(finding) {
    return (finding.accepted ?? null) !== null && this.entries.has(finding.id);
  }

  /** Accepts the chosen finding for a reason; null to accept it no longer. */
  set(reason) {
    const finding = this.chosen;
    if (!finding) return;
    const entry = this.entries.get(finding.id);
    if (reason !== null) Object.assign(entry, { reason, date: new Date().toISOString().slice(0, 10) });
    this.list.accept(finding.number, reason);
    this.show(finding);
  }

  /** The list as `--accept` reads it. */
  text() {
    const accepted = this.list.all.filter((one) => this.isAccepted(one)).map(({ id }) => this.entries.get(id));
    return `${JSON.stringify({ schema: this.schema, accepted }, null, 2)}\n`;
  }

  save() {
    const link = element("a", { download: "accepted.json", href: `data:application/json;charset=utf-8,${encodeURIComponent(this.text())}` });
    link.click();
  }
}
