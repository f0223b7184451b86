"""The director: where cameras stand and how they move, from what a scene does.

`takes` holds the record, `acting` says who must be seen when, `lens` how large, `paths` what each
kind of camera does, `staging` chooses among them, `review` measures what is seen of every event.
"""
